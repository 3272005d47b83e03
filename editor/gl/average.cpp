#include "gl/average.h"

#include "gl/shader_program.h"

namespace weftlight::gl {

bool Average::build(std::string& error) {
  program_ = build_program("backdrop.vert", "average.frag", {}, error);
  return error.empty();
}

void Average::draw(GLuint from, GLuint to) {
  glBindFramebuffer(GL_FRAMEBUFFER, to);
  glUseProgram(program_.preview_bake());
  glUniform1i(glGetUniformLocation(program_.preview_bake(), "pass_map"), 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, from);
  glBindVertexArray(nothing_.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

void Average::add(GLuint texture, GLuint framebuffer, int width, int height, float share) {
  if (width != width_ || height != height_) {
    width_ = width, height_ = height;
    glBindTexture(GL_TEXTURE_2D, mean_.get());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, width, height, 0, GL_RGBA, GL_HALF_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, mean_.get(), 0);
    share = 1;
  }
  glViewport(0, 0, width, height);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_FRAMEBUFFER_SRGB);
  // The first pass replaces what was there: fresh memory may hold what is no number, which a weight of nought keeps.
  share < 1 ? glEnable(GL_BLEND) : glDisable(GL_BLEND);
  glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
  glBlendColor(0, 0, 0, share);
  // texelFetch decodes on some drivers whatever the texture says of it (EXT_texture_sRGB_decode, on texelFetch), so
  // that it says what is wanted.
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SRGB_DECODE_EXT, GL_DECODE_EXT);
  draw(texture, target_.get());
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SRGB_DECODE_EXT, GL_SKIP_DECODE_EXT);
  glDisable(GL_BLEND);
  if (share < 1) {
    glEnable(GL_FRAMEBUFFER_SRGB);
    draw(mean_.get(), framebuffer);
    glDisable(GL_FRAMEBUFFER_SRGB);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace weftlight::gl
