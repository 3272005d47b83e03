#include "session/editing/orbit.h"

#include <algorithm>
#include <cmath>

#include "scene/named_views.h"

namespace weftlight::session {
namespace {

constexpr float kNearest = 0.001f, kFurthest = 8.0f;

}  // namespace

float wrapped_degrees(float degrees) { return degrees - 360 * std::floor((degrees + 180) / 360); }

Orbit orbit_of(const Scene& s) { return {s.view_azimuth, s.view_elevation, s.view_distance, s.pan_x, s.pan_y}; }

Orbit flat_orbit(const Design& design, float width_px, float height_px) {
  constexpr float kPixelsAYarn = 9;
  return {0, 0, scene::flat_distance(design, width_px, height_px, kPixelsAYarn), 0, 0};
}

Scene with_orbit(Scene s, const Orbit& camera) {
  s.view_azimuth = camera.azimuth;
  s.view_elevation = camera.elevation;
  s.view_distance = camera.distance;
  s.pan_x = camera.pan_x;
  s.pan_y = camera.pan_y;
  return s;
}

Orbit orbited(Orbit camera, float dx_px, float dy_px, float degrees_a_px) {
  camera.azimuth = wrapped_degrees(camera.azimuth - dx_px * degrees_a_px);
  camera.elevation = std::clamp(camera.elevation + dy_px * degrees_a_px, -89.0f, 89.0f);
  return camera;
}

Orbit zoomed(Orbit camera, float steps, float x, float y) {
  const float next = std::clamp(camera.distance * std::pow(0.88f, steps), kNearest, kFurthest);
  const float grow = camera.distance / next;
  camera.pan_x = x - (x - camera.pan_x) * grow;
  camera.pan_y = y - (y - camera.pan_y) * grow;
  camera.distance = next;
  return camera;
}

}  // namespace weftlight::session
