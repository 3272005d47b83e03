#pragma once
// Exposure of a picture in stops, from the reflectance of the cloth and the amount of light. It does not depend on the
// picture, so that zooming, turning and moving the light change nothing.

#include "design/design.h"
#include "scene/light_rig.h"
#include "shaders/interop.h"

namespace weftlight::scene {

using design::Look;

/// Mean reflectance (luminance, 0..1) of the visible parts of both faces, without the gaps: body and shine.
float mean_reflectance(const interop::ClothData& cloth);

/// Stops that brighten a cloth, more for a darker one, by two fifths of what would make all cloths equally bright, so
/// that a dark cloth still looks dark and a white one white.
float exposure_for(float reflectance);

/// Exposure of a picture: the design's own stops, and if it is automatic those of exposure_for() and rig_exposure().
float exposure_stops(const Look& look, const interop::ClothData& cloth, const LightRig& rig);

}  // namespace weftlight::scene
