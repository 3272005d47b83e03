#include "gl/gpu_hairs.h"

#include <algorithm>
#include <cmath>

#include "gl/shader_program.h"

namespace weftlight::gl {
namespace {

void attribute(Attribute slot, int size, size_t offset) {
  glEnableVertexAttribArray(slot);
  glVertexAttribPointer(slot, size, GL_FLOAT, GL_FALSE, sizeof(Hair), reinterpret_cast<const void*>(offset));
  glVertexAttribDivisor(slot, 1);
}

}  // namespace

int hair_pieces(const HairGrowth& growth, float pixel_mm) {
  constexpr int kLeast = 4, kMost = 12;  // fewer cut the bends short, and so what the fibres cover
  const float pixels = 2 * std::max(growth.length_mm[0], growth.length_mm[1]) / std::max(pixel_mm, 1e-6f);
  // An arc of one radian in k pieces is off by its length over 8 k^2; these have up to three radians and a
  // wave.
  return std::clamp(static_cast<int>(std::ceil(1.5f * std::sqrt(pixels))), kLeast, kMost);
}

bool GpuHairs::build(std::string& error) {
  program_ = build_program("hair.vert", "hair.frag", {"SHADOW_TAPS 4"}, error);
  if (!error.empty()) return false;
  glBindVertexArray(array_.get());
  glBindBuffer(GL_ARRAY_BUFFER, roots_.get());
  attribute(kPosition, 3, offsetof(Hair, root));
  attribute(kNormal, 3, offsetof(Hair, normal));
  attribute(kUv, 2, offsetof(Hair, uv_mm));
  attribute(kSky, 2, offsetof(Hair, sky));
  attribute(kHair, 4, offsetof(Hair, seed));
  glBindVertexArray(0);
  return true;
}

void GpuHairs::sow(const GpuMesh& mesh, const HairGrowth& growth, const HairView& view) {
  if (known_mesh_ && growth == growth_ && view == view_) return;
  if (!known_mesh_) hems_ = hems_of(mesh.prepared().mesh, mesh.prepared().fine);
  known_mesh_ = true, growth_ = growth, view_ = view;
  const std::vector<Hair> hairs = sow_hairs(mesh.prepared(), hems_, mesh.uv_origin_mm(), growth, view);
  count_ = hairs.size();
  glBindBuffer(GL_ARRAY_BUFFER, roots_.get());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(hairs.size() * sizeof(Hair)), hairs.data(), GL_STREAM_DRAW);
}

void GpuHairs::draw(int pieces) {
  if (!count_) return;
  glUseProgram(program_.peek());
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  glBindVertexArray(array_.get());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 2 * (pieces + 1), static_cast<GLsizei>(count_));
  glDepthMask(GL_TRUE);
}

}  // namespace weftlight::gl
