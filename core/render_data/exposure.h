#pragma once
// How bright a picture is shown: in stops, from what the cloth reflects and how much light there is. Nothing is read
// from the picture, so that zooming, turning and dragging the light change nothing.

#include "draft/design.h"
#include "render_data/light_rig.h"
#include "render_data/names.h"
#include "shaders/interop.h"

namespace weftlight::render_data {

/// Mean reflectance (luminance, 0..1) of what both faces show: the threads' bodies and their shine, without the gaps.
float mean_reflectance(const interop::ClothData& cloth);

/// Stops that lift a cloth, the more the darker it is, by two fifths of what would make all cloths alike: a dark cloth
/// shall still look dark, and a white one white.
float exposure_for(float reflectance);

/// What a picture is shown at: the design's own stops, and where it asks for them those of exposure_for() and
/// rig_exposure().
float exposure_stops(const Look& look, const interop::ClothData& cloth, const LightRig& rig);

}  // namespace weftlight::render_data
