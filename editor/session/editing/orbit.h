#pragma once
// The orbit camera of the cloth; not part of the design until it is saved.

#include "design/design.h"
#include "scene/named_views.h"

namespace weftlight::session {

using design::Design, design::Scene;

/// Scene::view_* and pan_* as the user changed them.
struct Orbit {
  float azimuth = 0, elevation = 0, distance = 1, pan_x = 0, pan_y = 0;
  bool operator==(const Orbit&) const = default;
};
Orbit orbit_of(const Scene& scene);
/// Straight on to a flat swatch that fills a picture of this size in pixels, with threads a few pixels wide.
Orbit flat_orbit(const Design& design, float width_px, float height_px);
Scene with_orbit(Scene scene, const Orbit& camera);

/// Drag by (dx, dy) and zoom about (x, y), all in pane widths and heights from the middle, y up.
Orbit orbited(Orbit camera, float dx_px, float dy_px, float degrees_a_px);
Orbit zoomed(Orbit camera, float steps, float x, float y);
/// -180 to 180.
float wrapped_degrees(float degrees);

}  // namespace weftlight::session
