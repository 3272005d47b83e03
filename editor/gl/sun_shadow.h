#pragma once
// The shadow map of the key light over cloth and body; drawn again only when the light or the mesh changes.

#include <glm/glm.hpp>
#include <string>

#include "gl/gl_objects.h"
#include "gl/gpu_mesh.h"
#include "gl/names.h"

namespace weftlight::gl {

class SunShadow {
 public:
  bool build(std::string& error);
  void forget() { drawn_ = false; }
  /// Draws the map if it is not that of this light, and says whether it did. Changes framebuffer and viewport.
  bool update(GpuMesh& mesh, glm::vec3 towards_light, GlBuffer& frame_block);
  void bind() const;

  int size() const { return kSize; }
  float texel_mm() const { return texel_mm_; }
  GLuint depth() const { return depth_.peek(); }
  const glm::mat4& world_to_shadow() const { return matrix_; }

 private:
  static constexpr int kSize = 1536;
  GlProgram program_;
  GlTexture depth_;
  GlFramebuffer framebuffer_;
  glm::mat4 matrix_{1};
  glm::vec3 light_{0};
  float texel_mm_ = 1;
  bool drawn_ = false;
};

}  // namespace weftlight::gl
