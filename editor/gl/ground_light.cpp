#include "gl/ground_light.h"

#include "gl/shader_program.h"
#include "shaders/interop.h"

namespace weftlight::gl {

base::Result<void> GroundLight::build() {
  if (auto built = build_into(bake_, "backdrop.vert", "ground_bake.frag", {"SHADOW_TAPS 4"}); !built) return built;
  if (auto built = build_into(program_, "ground.vert", "ground.frag", {"SHADOW_TAPS 4"}); !built) return built;
  glBindTexture(GL_TEXTURE_2D, light_.get());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, kSize, kSize, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, light_.get(), 0);
  return {};
}

void GroundLight::update(GLuint sun_depth, GLuint ground_sky) {
  glActiveTexture(GL_TEXTURE0 + kGroundSlot);
  glBindTexture(GL_TEXTURE_2D, ground_sky);
  glActiveTexture(GL_TEXTURE0 + kSunDepthSlot);
  glBindTexture(GL_TEXTURE_2D, sun_depth);
  opengl::compare_depths(GL_TEXTURE_2D, false);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  glViewport(0, 0, kSize, kSize);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glBindVertexArray(empty_array_.get());
  glUseProgram(bake_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  opengl::compare_depths(GL_TEXTURE_2D, true);
}

void GroundLight::draw() {
  glActiveTexture(GL_TEXTURE0 + kGroundSlot);
  glBindTexture(GL_TEXTURE_2D, light_.name());
  glBindVertexArray(empty_array_.get());
  glEnable(GL_BLEND);
  glUseProgram(program_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace weftlight::gl
