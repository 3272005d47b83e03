#pragma once
// Shadow maps of cloth and body, for the key light and the other lights of an environment; each is drawn again only
// when its light or the mesh changes.

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <string>

#include "base/result.h"
#include "gl/gl_objects.h"
#include "gl/gpu_mesh.h"
#include "scene/environment_light.h"

namespace weftlight::gl {

using scene::DistantLight, scene::kMaxLights;

/// The view of a light.
struct ShadowView {
  glm::vec3 towards{0};
  glm::mat4 world_to_shadow{1};  // to 0..1 in x, y and depth
  float texel_mm = 1;
  bool drawn = false;
};

class SunShadow {
 public:
  base::Result<void> build();
  void invalidate();
  /// Draws the map if it is not for this light, and returns whether it did. Changes framebuffer and viewport.
  bool update(GpuMesh& mesh, glm::vec3 towards_light, GlBuffer& frame_block);
  /// The same for the lights after the first, kMaxLights in total.
  void update_more(GpuMesh& mesh, std::span<const DistantLight> lights, GlBuffer& frame_block);
  void bind() const;

  int size() const { return kSize; }
  float texel_mm() const { return key_.texel_mm; }
  GLuint depth() const { return depth_.name(); }
  const glm::mat4& world_to_shadow() const { return key_.world_to_shadow; }
  /// Light i >= 1.
  const ShadowView& more(size_t i) const { return more_[i - 1]; }

 private:
  static constexpr int kSize = 2048, kMoreSize = 1024;
  void draw(GpuMesh& mesh, ShadowView& view, GLuint framebuffer, int size, GlBuffer& frame_block);

  GlProgram program_;
  GlTexture depth_, more_depth_;
  GlFramebuffer framebuffer_;
  std::array<GlFramebuffer, kMaxLights - 1> more_framebuffers_;
  ShadowView key_;
  std::array<ShadowView, kMaxLights - 1> more_;
};

}  // namespace weftlight::gl
