#pragma once
// Mean of pictures that are drawn one after another, each with other samples of the same scene: what a graphics
// card cannot sample at once becomes fine while nothing moves.

#include <string>

#include "gl/gl_objects.h"
#include "gl/names.h"

namespace weftlight::gl {

class Average {
 public:
  bool build(std::string& error);
  /// Takes the sRGB-encoded picture, whose share in the mean is above 0 to 1 (1 begins anew), and leaves the mean in
  /// its place.
  void add(GLuint texture, GLuint framebuffer, int width, int height, float weight);

 private:
  void draw(GLuint from, GLuint to);
  GlProgram program_;
  GlVertexArray nothing_;
  GlTexture mean_;  // linear
  GlFramebuffer target_;
  int width_ = 0, height_ = 0;
};

}  // namespace weftlight::gl
