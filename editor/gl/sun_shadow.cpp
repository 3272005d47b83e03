#include "gl/sun_shadow.h"

#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "gl/shader_program.h"
#include "shaders/interop.h"

namespace weftlight::gl {

bool SunShadow::build(std::string& error) {
  program_ = build_program("depth.vert", "depth.frag", {"SHADOW_TAPS 4"}, error);
  if (!error.empty()) return false;
  glBindTexture(GL_TEXTURE_2D, depth_.get());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kSize, kSize, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  constexpr float kLit[] = {1, 1, 1, 1};
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, kLit);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.get(), 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  return true;
}

bool SunShadow::update(GpuMesh& mesh, glm::vec3 towards_light, GlBuffer& frame_block) {
  if (drawn_ && towards_light == light_) return false;
  drawn_ = true, light_ = towards_light;
  Bounds all = mesh.prepared().bounds;
  if (!mesh.prepared().body.position_mm.empty()) {
    const Bounds body = bounds_of(mesh.prepared().body);
    all = {glm::min(all.low, body.low), glm::max(all.high, body.high)};
  }
  const float r = all.radius() * 1.02f + 1e-3f;
  const glm::vec3 centre = all.centre();
  const glm::vec3 up = std::abs(towards_light.y) > 0.99f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
  const glm::mat4 clip = glm::ortho(-r, r, -r, r, 0.0f, 2 * r) * glm::lookAt(centre + towards_light * r, centre, up);
  matrix_ = glm::translate(glm::mat4(1), glm::vec3(0.5f)) * glm::scale(glm::mat4(1), glm::vec3(0.5f)) * clip;
  texel_mm_ = 2 * r / kSize;

  interop::FrameData data{};
  data.world_to_shadow = matrix_;
  glBindBuffer(GL_UNIFORM_BUFFER, frame_block.get());
  glBufferData(GL_UNIFORM_BUFFER, sizeof data, &data, GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, frame_block.get());
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  glViewport(0, 0, kSize, kSize);
  glDepthMask(GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glClear(GL_DEPTH_BUFFER_BIT);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.5f, 2.0f);
  glUseProgram(program_.peek());
  mesh.draw_cloth();
  mesh.draw_body();
  glDisable(GL_POLYGON_OFFSET_FILL);
  return true;
}

void SunShadow::bind() const {
  glActiveTexture(GL_TEXTURE0 + kSunShadowSlot);
  glBindTexture(GL_TEXTURE_2D, depth_.peek());
}

}  // namespace weftlight::gl
