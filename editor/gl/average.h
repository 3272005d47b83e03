#pragma once
// Mean of pictures drawn one after another, each with different samples of the same scene: a still view converges to
// what a card cannot sample at once.

#include <string>

#include "base/result.h"
#include "gl/gl_objects.h"

namespace weftlight::gl {

class Average {
 public:
  base::Result<void> build();
  /// Averages the sRGB-encoded picture into the mean with this weight, above 0 to 1 (1 starts anew), and replaces the
  /// picture by the mean.
  void add(GLuint texture, GLuint framebuffer, int width, int height, float weight);

 private:
  void draw(GLuint from, GLuint to);
  GlProgram program_;
  GlVertexArray empty_array_;
  GlTexture mean_;  // linear
  GlFramebuffer target_;
  int width_ = 0, height_ = 0;
};

}  // namespace weftlight::gl
