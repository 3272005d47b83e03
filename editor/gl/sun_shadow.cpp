#include "gl/sun_shadow.h"

#include <algorithm>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <limits>

#include "gl/shader_program.h"
#include "shaders/interop.h"

namespace weftlight::gl {

using render_data::PreparedMesh;
using scene::Bounds, scene::bounds_of;

namespace {

/// Beyond its border a map is lit.
void read_as_shadow(GLenum target) {
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  opengl::light_beyond_border(target);
  glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(target, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

Bounds bounds_with_body(const PreparedMesh& mesh) {
  if (mesh.body.position_mm.empty()) return mesh.bounds;
  const Bounds body = bounds_of(mesh.body);
  return {glm::min(mesh.bounds.low, body.low), glm::max(mesh.bounds.high, body.high)};
}

struct Square {
  glm::vec2 centre{0};
  float half = 0;  // of its side
};

/// The square around cloth and body as a light sees them. A texel is a step in the edge of a shadow, and a surface lit
/// aslant draws it out to a tooth, so none is spent beside them.
Square square_around(const PreparedMesh& mesh, const glm::mat4& view) {
  if (mesh.mesh.position_mm.empty()) return {};
  constexpr float kFar = std::numeric_limits<float>::max();
  glm::vec2 low(kFar), high(-kFar);
  for (const drape::Mesh* part : {&mesh.mesh, &mesh.body}) {
    for (const drape::Vec3& p : part->position_mm) {
      const glm::vec2 at(view * glm::vec4(p, 1));
      low = glm::min(low, at), high = glm::max(high, at);
    }
  }
  return {0.5f * (low + high), 0.5f * std::max(high.x - low.x, high.y - low.y)};
}

}  // namespace

base::Result<void> SunShadow::build() {
  if (auto built = build_into(program_, "depth.vert", "depth.frag", {"SHADOW_TAPS 4"}); !built) return built;
  glBindTexture(GL_TEXTURE_2D, depth_.get());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kSize, kSize, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
  read_as_shadow(GL_TEXTURE_2D);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.get(), 0);
  opengl::draw_depth_only();
  return {};
}

void SunShadow::invalidate() {
  key_.drawn = false;
  for (ShadowView& view : more_) view.drawn = false;
}

bool SunShadow::update(GpuMesh& mesh, glm::vec3 towards_light, GlBuffer& frame_block) {
  if (key_.drawn && towards_light == key_.towards) return false;
  key_.towards = towards_light;
  draw(mesh, key_, framebuffer_.get(), kSize, frame_block);
  return true;
}

void SunShadow::update_more(GpuMesh& mesh, std::span<const DistantLight> lights, GlBuffer& frame_block) {
  if (lights.size() > 1 && !more_depth_.name()) {
    glBindTexture(GL_TEXTURE_2D_ARRAY, more_depth_.get());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT24, kMoreSize, kMoreSize, static_cast<GLsizei>(more_.size()),
                 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
    read_as_shadow(GL_TEXTURE_2D_ARRAY);
    for (size_t i = 0; i < more_.size(); ++i) {
      glBindFramebuffer(GL_FRAMEBUFFER, more_framebuffers_[i].get());
      glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, more_depth_.name(), 0, static_cast<GLint>(i));
      opengl::draw_depth_only();
    }
  }
  for (size_t i = 1; i < lights.size() && i < kMaxLights; ++i) {
    ShadowView& view = more_[i - 1];
    if (view.drawn && view.towards == lights[i].towards) continue;
    view.towards = lights[i].towards;
    draw(mesh, view, more_framebuffers_[i - 1].get(), kMoreSize, frame_block);
  }
}

void SunShadow::draw(GpuMesh& mesh, ShadowView& view, GLuint framebuffer, int size, GlBuffer& frame_block) {
  const Bounds all = bounds_with_body(mesh.prepared());
  const float r = all.radius() * 1.02f + 1e-3f;
  const glm::vec3 centre = all.centre();
  const glm::vec3 up = std::abs(view.towards.y) > 0.99f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
  const glm::mat4 from_light = glm::lookAt(centre + view.towards * r, centre, up);
  const Square square = square_around(mesh.prepared(), from_light);
  const float half = square.half * 1.02f + 1e-3f;
  const glm::vec2 low = square.centre - half, high = square.centre + half;
  const glm::mat4 clip = glm::ortho(low.x, high.x, low.y, high.y, 0.0f, 2 * r) * from_light;
  view.world_to_shadow =
      glm::translate(glm::mat4(1), glm::vec3(0.5f)) * glm::scale(glm::mat4(1), glm::vec3(0.5f)) * clip;
  view.texel_mm = 2 * half / static_cast<float>(size);
  view.drawn = true;

  interop::FrameData data{};
  data.world_to_shadow = view.world_to_shadow;
  glBindBuffer(GL_UNIFORM_BUFFER, frame_block.get());
  glBufferData(GL_UNIFORM_BUFFER, sizeof data, &data, GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, frame_block.get());
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, size, size);
  glDepthMask(GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glClear(GL_DEPTH_BUFFER_BIT);
  opengl::begin_lit_border(size);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.5f, 2.0f);
  glUseProgram(program_.name());
  mesh.draw_cloth();
  mesh.draw_body();
  glDisable(GL_POLYGON_OFFSET_FILL);
  opengl::end_lit_border();
}

void SunShadow::bind() const {
  glActiveTexture(GL_TEXTURE0 + kSunShadowSlot);
  glBindTexture(GL_TEXTURE_2D, depth_.name());
  if (!more_depth_.name()) return;
  glActiveTexture(GL_TEXTURE0 + kMoreShadowSlot);
  glBindTexture(GL_TEXTURE_2D_ARRAY, more_depth_.name());
}

}  // namespace weftlight::gl
