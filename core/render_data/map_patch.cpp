#include "render_data/map_patch.h"

#include <glm/gtc/matrix_inverse.hpp>

namespace weftlight::render_data {

using scene::bounds_of;

namespace {

constexpr float kAway = 1e6f;  // mm; the rays of a patch of 10 cm differ by less than a hundredth of a degree
constexpr float kMargin = 2;   // pixels beyond the rim

glm::vec2 at(const FlatPatch& p, float x, float y) { return p.corner_mm + x * p.step_x_mm + y * p.step_y_mm; }

}  // namespace

PreparedMesh patch_mesh(const FlatPatch& patch) {
  PreparedMesh prepared;
  const float w = static_cast<float>(patch.width) + kMargin, h = static_cast<float>(patch.height) + kMargin;
  for (const glm::vec2 p :
       {at(patch, -kMargin, -kMargin), at(patch, w, -kMargin), at(patch, -kMargin, h), at(patch, w, h)}) {
    prepared.mesh.position_mm.push_back({p.x, p.y, 0});
    prepared.mesh.normal.push_back({0, 0, 1});
    prepared.mesh.tangent.push_back({1, 0, 0});
    prepared.mesh.uv_mm.push_back({p.x, p.y});
  }
  // Rows run downwards on screen, which reverses the winding.
  prepared.mesh.index = {0, 2, 1, 1, 2, 3};
  prepared.sky.resize(4);
  prepared.bounds = bounds_of(prepared.mesh);
  return prepared;
}

Camera patch_camera(const FlatPatch& patch) {
  // (x, y) of the plane to pixels, then to the clip square, row 0 on top.
  const glm::mat2 to_pixels = glm::inverse(glm::mat2(patch.step_x_mm, patch.step_y_mm));
  const glm::vec2 scale(2 / static_cast<float>(patch.width), -2 / static_cast<float>(patch.height));
  const glm::mat2 turn(scale * to_pixels[0], scale * to_pixels[1]);
  const glm::vec2 shift = glm::vec2(-1, 1) - turn * patch.corner_mm;
  Camera camera;
  camera.world_to_clip = glm::mat4(0);
  camera.world_to_clip[0] = glm::vec4(turn[0], 0, 0);
  camera.world_to_clip[1] = glm::vec4(turn[1], 0, 0);
  camera.world_to_clip[3] = glm::vec4(shift, 0, 1);
  const glm::vec2 middle = at(patch, static_cast<float>(patch.width) / 2, static_cast<float>(patch.height) / 2);
  camera.eye = glm::vec3(middle, 0) + patch.view * kAway;
  camera.pixel_mm = glm::length(patch.step_x_mm);
  return camera;
}

}  // namespace weftlight::render_data
