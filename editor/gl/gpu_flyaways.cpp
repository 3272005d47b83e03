#include "gl/gpu_flyaways.h"

#include <algorithm>
#include <cmath>

#include "gl/shader_program.h"

namespace weftlight::gl {

using render_data::Flyaway, render_data::hems_of, render_data::scatter_flyaways;

namespace {

void attribute(Attribute slot, int size, size_t offset) {
  glEnableVertexAttribArray(slot);
  glVertexAttribPointer(slot, size, GL_FLOAT, GL_FALSE, sizeof(Flyaway), reinterpret_cast<const void*>(offset));
  glVertexAttribDivisor(slot, 1);
}

}  // namespace

int flyaway_pieces(const FlyawayGrowth& growth, float pixel_mm) {
  constexpr int kMin = 4, kMax = 12;  // fewer segments shorten the bends, and so the coverage
  const float pixels = 2 * std::max(growth.length_mm[0], growth.length_mm[1]) / std::max(pixel_mm, 1e-6f);
  // An arc of one radian in k segments is off by its length over 8 k^2; fibres have up to three radians and a wave.
  return std::clamp(static_cast<int>(std::ceil(1.5f * std::sqrt(pixels))), kMin, kMax);
}

base::Result<void> GpuFlyaways::build() {
  if (auto built = build_into(program_, "flyaway.vert", "flyaway.frag", {"SHADOW_TAPS 4"}); !built) return built;
  glBindVertexArray(array_.get());
  glBindBuffer(GL_ARRAY_BUFFER, roots_.get());
  attribute(kPosition, 3, offsetof(Flyaway, root));
  attribute(kNormal, 3, offsetof(Flyaway, normal));
  attribute(kUv, 2, offsetof(Flyaway, uv_mm));
  attribute(kSky, 2, offsetof(Flyaway, sky));
  attribute(kFlyaway, 4, offsetof(Flyaway, seed));
  glBindVertexArray(0);
  return {};
}

void GpuFlyaways::scatter(const GpuMesh& mesh, const FlyawayGrowth& growth, const FlyawayView& view) {
  if (known_mesh_ && growth == growth_ && view == view_) return;
  if (!known_mesh_) hems_ = hems_of(mesh.prepared().mesh, mesh.prepared().fine);
  known_mesh_ = true, growth_ = growth, view_ = view;
  const std::vector<Flyaway> flyaways = scatter_flyaways(mesh.prepared(), hems_, mesh.uv_origin_mm(), growth, view);
  count_ = flyaways.size();
  glBindBuffer(GL_ARRAY_BUFFER, roots_.get());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(flyaways.size() * sizeof(Flyaway)), flyaways.data(),
               GL_STREAM_DRAW);
}

void GpuFlyaways::draw(int pieces) {
  if (!count_) return;
  glUseProgram(program_.name());
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  glBindVertexArray(array_.get());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 2 * (pieces + 1), static_cast<GLsizei>(count_));
  glDepthMask(GL_TRUE);
}

}  // namespace weftlight::gl
