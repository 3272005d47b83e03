#include "gl/average.h"

#include "gl/shader_program.h"

namespace weftlight::gl {

using opengl::decode_srgb, opengl::encode_srgb;

base::Result<void> Average::build() { return build_into(program_, "backdrop.vert", "average.frag", {}); }

void Average::draw(GLuint from, GLuint to) {
  glBindFramebuffer(GL_FRAMEBUFFER, to);
  glUseProgram(program_.name());
  glUniform1i(glGetUniformLocation(program_.name(), "pass_map"), 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, from);
  glBindVertexArray(empty_array_.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

void Average::add(GLuint texture, GLuint framebuffer, int width, int height, float weight) {
  if (width != width_ || height != height_) {
    width_ = width, height_ = height;
    glBindTexture(GL_TEXTURE_2D, mean_.get());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, width, height, 0, GL_RGBA, GL_HALF_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, mean_.get(), 0);
    weight = 1;
  }
  glViewport(0, 0, width, height);
  glDisable(GL_DEPTH_TEST);
  encode_srgb(false);
  // The first pass replaces the content: fresh memory may hold NaN, which a weight of 0 keeps.
  weight < 1 ? glEnable(GL_BLEND) : glDisable(GL_BLEND);
  glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
  glBlendColor(0, 0, 0, weight);
  // On some drivers texelFetch always decodes sRGB (EXT_texture_sRGB_decode, on texelFetch), so the texture is set to
  // decode here.
  glBindTexture(GL_TEXTURE_2D, texture);
  decode_srgb(true);
  draw(texture, target_.get());
  glBindTexture(GL_TEXTURE_2D, texture);
  decode_srgb(false);
  glDisable(GL_BLEND);
  if (weight < 1) {
    encode_srgb(true);
    draw(mean_.get(), framebuffer);
    encode_srgb(false);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace weftlight::gl
