#pragma once
// The graphics interface that is drawn with, and all in which its two kinds differ: OpenGL 3.3 core, loaded by
// libepoxy; or OpenGL ES 3.0 (WEFTLIGHT_GLES), which is WebGL 2 in a browser. Both draw the same picture by the same
// shaders.

#if WEFTLIGHT_GLES
#include <GLES3/gl3.h>
#else
#include <epoxy/gl.h>
#endif

#include <string_view>

#if WEFTLIGHT_GLES
// third_party/web/glfw_rest.js
extern "C" int weftlight_lost_contexts(void);
extern "C" int weftlight_context_is_lost(void);
#endif

namespace weftlight::opengl {

#if WEFTLIGHT_GLES

inline constexpr bool kGles = true;
inline constexpr const char* kShaderHead =
    "#version 300 es\n"
    "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\nprecision highp sampler3D;\n"
    "precision highp samplerCube;\nprecision highp sampler2DArray;\nprecision highp sampler2DShadow;\n"
    "precision highp sampler2DArrayShadow;\nprecision highp usampler2D;\nprecision highp usampler2DArray;\n";
inline constexpr const char* kImGuiShaderHead = "#version 300 es";
// Textures that are read between their texels: ES need not do that with single precision.
inline constexpr GLint kSmoothRgb = GL_RGB16F, kSmoothRgba = GL_RGBA16F, kSmoothRg = GL_RG16F;
inline constexpr GLenum kWindowLayout = GL_RGBA, kWindowType = GL_UNSIGNED_BYTE;

inline bool is_new_enough() { return true; }  // it is ES 3.0 or there is no context at all
// A browser takes the context of a page, and gives it back empty.
inline constexpr bool kComesBack = true;
inline bool can_tell_reset() { return true; }
/// Whether it is away.
inline bool was_reset() { return weftlight_context_is_lost() != 0; }
/// How often it went away and may have come back since.
inline int resets() { return weftlight_lost_contexts(); }
inline const char* renderer_name() {
  // WEBGL_debug_renderer_info, where the page could ask for it; else a name that tells nothing.
  constexpr GLenum kUnmaskedRenderer = 0x9246;
  if (const GLubyte* name = glGetString(kUnmaskedRenderer)) return reinterpret_cast<const char*>(name);
  while (glGetError() != GL_NO_ERROR) {
  }
  return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

// ES always encodes what is drawn into sRGB, and decodes what is read from it.
inline void encode_srgb(bool /*on*/) {}
inline void decode_srgb(bool /*on*/) {}
// ES always draws with all samples, and filters across the edges of a cube.
inline void use_multisample() {}
inline void use_seamless_cubes() {}
inline void name_output(GLuint /*program*/, const char* /*name*/) {}  // a single one is the first
inline void allow_compiling_aside() {}                                // a browser does so by itself
inline void draw_depth_only() {
  constexpr GLenum kNone = GL_NONE;
  glDrawBuffers(1, &kNone);
  glReadBuffer(GL_NONE);
}

/// Beyond its border a map of depths is lit. Without a colour of the border its outermost texels are: see
/// begin_lit_border.
inline void light_beyond_border(GLenum target) {
  glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}
/// Between these, nothing is drawn into the outermost texels of a cleared map of depths.
inline void begin_lit_border(int size) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(1, 1, size - 2, size - 2);
}
inline void end_lit_border() { glDisable(GL_SCISSOR_TEST); }
/// A map of depths is read as numbers, or compared. ES reads numbers of depth without a filter.
inline void compare_depths(GLenum target, bool on) {
  glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, on ? GL_COMPARE_REF_TO_TEXTURE : GL_NONE);
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, on ? GL_LINEAR : GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, on ? GL_LINEAR : GL_NEAREST);
}

/// Waits until all is drawn. Browsers do not wait in glFinish, but for a pixel that is read.
inline void finish() {
  GLint bound = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &bound);
  GLuint target = 0, plane = 0;
  glGenFramebuffers(1, &target);
  glGenRenderbuffers(1, &plane);
  glBindRenderbuffer(GL_RENDERBUFFER, plane);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 1, 1);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, target);
  glFramebufferRenderbuffer(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, plane);
  GLubyte pixel[4];
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(bound));
  glDeleteFramebuffers(1, &target);
  glDeleteRenderbuffers(1, &plane);
}

// Neither the time of the card nor a number of samples can be asked for.
inline constexpr bool kHasCounters = false;
enum class Counter { kTime, kSamples };
inline void begin_counter(Counter /*what*/, GLuint /*query*/) {}
inline void end_counter(Counter /*what*/) {}
inline bool is_counted(GLuint /*query*/) { return true; }
inline double counted(GLuint /*query*/) { return 0; }

#else

inline constexpr bool kGles = false;
inline constexpr const char* kShaderHead = "#version 330 core\n";
inline constexpr const char* kImGuiShaderHead = "#version 330 core";
inline constexpr GLint kSmoothRgb = GL_RGB32F, kSmoothRgba = GL_RGBA32F, kSmoothRg = GL_RG32F;
// The channel order of windows, so that presenting is a plain copy.
inline constexpr GLenum kWindowLayout = GL_BGRA, kWindowType = GL_UNSIGNED_INT_8_8_8_8_REV;

inline bool is_new_enough() { return epoxy_gl_version() >= 33; }
// libepoxy ends the program where a function is called that the driver does not have.
inline bool can_tell_reset() { return epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_KHR_robustness"); }
inline bool was_reset() { return glGetGraphicsResetStatus() != GL_NO_ERROR; }
// One that was reset does not come back: another is made.
inline constexpr bool kComesBack = false;
inline int resets() { return 0; }
inline const char* renderer_name() { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

/// Whether what is drawn into sRGB is encoded.
inline void encode_srgb(bool on) { on ? glEnable(GL_FRAMEBUFFER_SRGB) : glDisable(GL_FRAMEBUFFER_SRGB); }
/// Whether what is read from the bound texture in sRGB is decoded.
inline void decode_srgb(bool on) {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SRGB_DECODE_EXT, on ? GL_DECODE_EXT : GL_SKIP_DECODE_EXT);
}
inline void use_multisample() { glEnable(GL_MULTISAMPLE); }
inline void use_seamless_cubes() { glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS); }
inline void name_output(GLuint program, const char* name) { glBindFragDataLocation(program, 0, name); }
/// The drivers of some cards compile on threads of their own only when told how many; eight are enough for two
/// programs.
inline void allow_compiling_aside() {
  constexpr GLuint kThreads = 8;
  if (epoxy_has_gl_extension("GL_KHR_parallel_shader_compile")) glMaxShaderCompilerThreadsKHR(kThreads);
  else if (epoxy_has_gl_extension("GL_ARB_parallel_shader_compile")) glMaxShaderCompilerThreadsARB(kThreads);
}
inline void draw_depth_only() {
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
}

/// Beyond its border a map of depths is lit.
inline void light_beyond_border(GLenum target) {
  constexpr float kLit[] = {1, 1, 1, 1};
  glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, kLit);
}
inline void begin_lit_border(int /*size*/) {}
inline void end_lit_border() {}
/// A map of depths is read as numbers, or compared.
inline void compare_depths(GLenum target, bool on) {
  glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, on ? GL_COMPARE_REF_TO_TEXTURE : GL_NONE);
}

/// Waits until all is drawn.
inline void finish() { glFinish(); }

/// What the card counts while it draws: nanoseconds, samples.
inline constexpr bool kHasCounters = true;
enum class Counter : GLenum { kTime = GL_TIME_ELAPSED, kSamples = GL_SAMPLES_PASSED };
inline void begin_counter(Counter what, GLuint query) { glBeginQuery(static_cast<GLenum>(what), query); }
inline void end_counter(Counter what) { glEndQuery(static_cast<GLenum>(what)); }
inline bool is_counted(GLuint query) {
  GLuint ready = GL_FALSE;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &ready);
  return ready != GL_FALSE;
}
/// Waits for it.
inline double counted(GLuint query) {
  GLuint64 count = 0;
  glGetQueryObjectui64v(query, GL_QUERY_RESULT, &count);
  return static_cast<double>(count);
}

#endif

/// Whether the driver compiles on threads of its own and can be asked whether it is done.
inline bool compiles_aside() {
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint k = 0; k < count; ++k) {
    const auto* name = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(k)));
    const std::string_view one = name ? name : "";
    if (one == "GL_KHR_parallel_shader_compile" || one == "GL_ARB_parallel_shader_compile") return true;
  }
  return false;
}
/// Whether a program that was linked can be asked for its state without a wait. Only where compiles_aside().
inline bool is_linked(GLuint program) {
  constexpr GLenum kCompletionStatus = 0x91B1;  // GL_COMPLETION_STATUS_KHR, which ES has no name for
  GLint done = GL_TRUE;
  glGetProgramiv(program, kCompletionStatus, &done);
  if (done != GL_FALSE) return true;
  return kGles && glGetError() != GL_NO_ERROR;  // a browser that lists the extension and does not know the question
}

}  // namespace weftlight::opengl
