#pragma once
// Owners of OpenGL objects: freed at the end of their scope, movable, not copyable.

#include <utility>

#include "opengl/opengl.h"

namespace weftlight::gl {

template <void (*Make)(GLuint&), void (*Free)(GLuint)>
class GlName {
 public:
  GlName() = default;
  GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlName() {
    if (name_) Free(name_);
  }
  /// The name; creates the object on first use.
  GLuint get() {
    if (!name_) Make(name_);
    return name_;
  }
  /// The name, 0 before the first get().
  GLuint name() const { return name_; }
  void reset() {
    if (name_) Free(std::exchange(name_, 0));
  }

 private:
  GLuint name_ = 0;
};

namespace gl_detail {
inline void make_texture(GLuint& n) { glGenTextures(1, &n); }
inline void free_texture(GLuint n) { glDeleteTextures(1, &n); }
inline void make_buffer(GLuint& n) { glGenBuffers(1, &n); }
inline void free_buffer(GLuint n) { glDeleteBuffers(1, &n); }
inline void make_array(GLuint& n) { glGenVertexArrays(1, &n); }
inline void free_array(GLuint n) { glDeleteVertexArrays(1, &n); }
inline void make_target(GLuint& n) { glGenFramebuffers(1, &n); }
inline void free_target(GLuint n) { glDeleteFramebuffers(1, &n); }
inline void make_plane(GLuint& n) { glGenRenderbuffers(1, &n); }
inline void free_plane(GLuint n) { glDeleteRenderbuffers(1, &n); }
inline void make_query(GLuint& n) { glGenQueries(1, &n); }
inline void free_query(GLuint n) { glDeleteQueries(1, &n); }
inline void make_program(GLuint& n) { n = glCreateProgram(); }
inline void free_program(GLuint n) { glDeleteProgram(n); }
inline void make_vertex_shader(GLuint& n) { n = glCreateShader(GL_VERTEX_SHADER); }
inline void make_fragment_shader(GLuint& n) { n = glCreateShader(GL_FRAGMENT_SHADER); }
inline void free_shader(GLuint n) { glDeleteShader(n); }
}  // namespace gl_detail

using GlTexture = GlName<gl_detail::make_texture, gl_detail::free_texture>;
using GlBuffer = GlName<gl_detail::make_buffer, gl_detail::free_buffer>;
using GlVertexArray = GlName<gl_detail::make_array, gl_detail::free_array>;
using GlFramebuffer = GlName<gl_detail::make_target, gl_detail::free_target>;
using GlRenderbuffer = GlName<gl_detail::make_plane, gl_detail::free_plane>;
using GlQuery = GlName<gl_detail::make_query, gl_detail::free_query>;
using GlProgram = GlName<gl_detail::make_program, gl_detail::free_program>;
using GlVertexShader = GlName<gl_detail::make_vertex_shader, gl_detail::free_shader>;
using GlFragmentShader = GlName<gl_detail::make_fragment_shader, gl_detail::free_shader>;

}  // namespace weftlight::gl
