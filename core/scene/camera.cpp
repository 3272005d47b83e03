#include "scene/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace weftlight::scene {

using drape::Vec3;

namespace {

constexpr float kFieldOfViewDeg = 26.0f;  // of the bounding sphere, like a portrait lens
constexpr float kGirth = 0.86f;           // of the half diagonal of the bounds, seen from above
constexpr float kMargin = 1.14f;          // space around it
constexpr float kFilled = 0.965f;         // of the picture at most, by what reaches furthest

/// Distance along the ray to the first triangle, or infinity (Moeller, Trumbore 1997).
float cast(const Mesh& mesh, glm::vec3 from, glm::vec3 along) {
  float nearest = std::numeric_limits<float>::infinity();
  for (size_t i = 0; i + 2 < mesh.index.size(); i += 3) {
    const glm::vec3 a = mesh.position_mm[mesh.index[i]];
    const glm::vec3 ab = mesh.position_mm[mesh.index[i + 1]] - a, ac = mesh.position_mm[mesh.index[i + 2]] - a;
    const glm::vec3 p = glm::cross(along, ac);
    const float det = glm::dot(ab, p);
    if (std::abs(det) < 1e-12f) continue;
    const glm::vec3 s = from - a;
    const float u = glm::dot(s, p) / det;
    const glm::vec3 q = glm::cross(s, ab);
    const float v = glm::dot(along, q) / det;
    if (u < 0 || v < 0 || u + v > 1) continue;
    const float t = glm::dot(ac, q) / det;
    if (t > 0) nearest = std::min(nearest, t);
  }
  return nearest;
}

/// Radius of an upright cylinder that cloth fills: seldom up to the corners of its bounds.
float girth_of(const Bounds& bounds) {
  const glm::vec3 half = 0.5f * (bounds.high - bounds.low);
  return std::sqrt(half.x * half.x + half.z * half.z) * kGirth;
}

/// The half width that a picture has room for beside its margins. Sleeves and corners of a cushion reach further than
/// the girth, whichever way they are turned.
float half_width_of(const Bounds& bounds) { return std::max(girth_of(bounds), bounds.reach); }

/// How a cloth is looked at: unit vectors of the picture, and the distance of the eye from the centre of the bounds.
struct Gaze {
  glm::vec3 right, up, back;
  float away, aspect;
};

Gaze gaze_of(float azimuth, float elevation, const Bounds& bounds, float aspect) {
  const glm::vec3 back = direction_of(azimuth, elevation);
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), back));
  const float away = std::max(bounds.radius(), 1e-3f) / std::sin(glm::radians(kFieldOfViewDeg) / 2);
  return {right, glm::cross(back, right), back, away, aspect};
}

/// The half height, as a tangent, of a picture whose edges the cloth does not cross. A form is taken as the body that
/// it fills while it is turned, so that this does not depend on the azimuth: each of its points goes round in a circle,
/// which is highest or lowest in the picture at its front or its back, and widest where a ray from the eye touches it.
/// Without a mesh a form needs no height.
float height_to_hold(const Gaze& gaze, const Mesh& mesh, const Bounds& bounds) {
  const auto depth = [&gaze](glm::vec3 p) { return gaze.away - glm::dot(gaze.back, p); };
  const auto above = [&](glm::vec3 p) { return std::abs(glm::dot(gaze.up, p)) / depth(p); };
  const glm::vec3 centre = bounds.centre(), corner = bounds.high - centre;
  float height = 0;
  if (corner.z <= 0) {
    for (const float x : {-corner.x, corner.x})
      for (const float y : {-corner.y, corner.y}) {
        const glm::vec3 p(x, y, 0);
        height = std::max({height, above(p), std::abs(glm::dot(gaze.right, p)) / depth(p) / gaze.aspect});
      }
    return height;
  }
  const glm::vec3 towards = glm::cross(gaze.right, glm::vec3(0, 1, 0));
  for (const Vec3& place : mesh.position_mm) {
    const glm::vec3 p = place - centre, middle(0, p.y, 0);
    const float radius = std::hypot(p.x, p.z), deep = depth(middle), nearer = radius * glm::dot(gaze.back, towards);
    const float aside = radius / std::sqrt(deep * deep - nearer * nearer);
    height =
        std::max({height, above(middle + radius * towards), above(middle - radius * towards), aside / gaze.aspect});
  }
  return height;
}

/// The half height of the picture at view_distance 1, as a tangent. An upright cylinder around the bounds fills it, so
/// that the framing is constant while the view turns.
float framed_height(const Gaze& gaze, float elevation, const Mesh& mesh, const Bounds& bounds) {
  const float tilt = std::abs(glm::radians(elevation));
  const float tall = 0.5f * (bounds.high.y - bounds.low.y) * std::cos(tilt) + girth_of(bounds) * std::sin(tilt);
  const float cylinder = std::max({tall, half_width_of(bounds) / gaze.aspect, 1e-3f}) * kMargin / gaze.away;
  return std::max(cylinder, height_to_hold(gaze, mesh, bounds) / kFilled);
}

}  // namespace

Bounds bounds_of(const Mesh& mesh) {
  if (mesh.position_mm.empty()) return {};
  Bounds b{mesh.position_mm[0], mesh.position_mm[0]};
  for (const Vec3& p : mesh.position_mm) b.low = glm::min(b.low, p), b.high = glm::max(b.high, p);
  if (b.high.z <= b.low.z) return b;
  const glm::vec3 centre = b.centre();
  for (const Vec3& p : mesh.position_mm) b.reach = std::max(b.reach, std::hypot(p.x - centre.x, p.z - centre.z));
  return b;
}

glm::vec3 direction_of(float azimuth_deg, float elevation_deg) {
  const float a = glm::radians(azimuth_deg), e = glm::radians(elevation_deg);
  return {std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)};
}

Camera place_camera(const Scene& scene, const Mesh& mesh, const Bounds& bounds, int width, int height,
                    float yarns_per_pixel, float mean_spacing_mm) {
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  const float elevation = std::clamp(scene.view_elevation, -89.9f, 89.9f);
  const Gaze gaze = gaze_of(scene.view_azimuth, elevation, bounds, aspect);
  const float away = gaze.away * std::max(1.0f, scene.view_distance);
  float tan_y = framed_height(gaze, elevation, mesh, bounds) * std::min(1.0f, std::max(scene.view_distance, 1e-4f));

  const float frame_mm = 2 * away * tan_y * aspect;
  const glm::vec3 target = bounds.centre() - gaze.right * (scene.pan_x * frame_mm) - gaze.up * (scene.pan_y * frame_mm);
  Camera camera;
  camera.eye = target + gaze.back * away;
  const float hit = cast(mesh, camera.eye, -gaze.back);
  const float surface = std::isfinite(hit) ? hit : away;
  if (yarns_per_pixel > 0 && mean_spacing_mm > 0) {
    tan_y = yarns_per_pixel * mean_spacing_mm * static_cast<float>(height) / (2 * surface);
  }
  camera.pixel_mm = 2 * surface * tan_y / static_cast<float>(height);
  const float reach = bounds.radius() * 8;
  const float near = std::max(away - bounds.radius() * 2.2f, away * 0.02f);
  const glm::mat4 view = glm::lookAt(camera.eye, target, glm::vec3(0, 1, 0));
  camera.world_to_clip = glm::perspective(2 * std::atan(tan_y), aspect, near, away + reach) * view;
  return camera;
}

float distance_of_height(const Bounds& bounds, float aspect, float height_mm) {
  const Gaze straight = gaze_of(0, 0, bounds, aspect);
  return std::min(1.0f, height_mm / (2 * straight.away * framed_height(straight, 0, {}, bounds)));
}

}  // namespace weftlight::scene
