#pragma once
// The light on the ground about the cloth, drawn into a small texture when the light or the mesh changes, so
// that a frame spends one fetch on it.

#include <string>

#include "gl/gl_objects.h"
#include "gl/names.h"

namespace weftlight::gl {

class GroundLight {
 public:
  bool build(std::string& error);
  /// Needs the frame block of the picture; reads the depths of the key light and what the ground sees of the sky.
  void update(GLuint sun_depth, GLuint ground_sky);
  /// Blends the ground into the target that is bound.
  void draw();

 private:
  static constexpr int kSize = 320;
  GlProgram bake_, program_;
  GlTexture light_;
  GlFramebuffer framebuffer_;
  GlVertexArray nothing_;
};

}  // namespace weftlight::gl
