#pragma once
// The light on the ground around the cloth, baked into a small texture when light or mesh change, so that a frame
// needs one fetch.

#include <string>

#include "base/result.h"
#include "gl/gl_objects.h"

namespace weftlight::gl {

class GroundLight {
 public:
  base::Result<void> build();
  /// Needs the frame block bound; reads the shadow map of the key light and the sky visibility of the ground.
  void update(GLuint sun_depth, GLuint ground_sky);
  /// Blends the ground into the bound target.
  void draw();

 private:
  static constexpr int kSize = 320;
  GlProgram bake_, program_;
  GlTexture light_;
  GlFramebuffer framebuffer_;
  GlVertexArray empty_array_;
};

}  // namespace weftlight::gl
