// EGL without a surface: Mesa's surfaceless platform first (a GPU or llvmpipe), then the default display
// of the vendor's driver.

#include "gl/egl_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <memory>
#include <string>
#include <utility>

#include "base/text.h"
#include "platform/shared_library.h"

namespace weftlight::gl {

using base::tr;

namespace {

base::Failure none(std::string why) { return base::failure(base::ErrorKind::kGraphics, std::move(why)); }

/// libepoxy exits the program if a library that it loads is missing.
std::string missing_library() {
  if (!platform::has_library("libEGL.so.1"))
    return tr("libEGL.so.1 was not found: install it (Debian: libegl1 and libgl1-mesa-dri)");
  if (!platform::has_library("libOpenGL.so.0") && !platform::has_library("libGL.so.1"))
    return tr("libGL.so.1 was not found: install it (Debian: libgl1 and libgl1-mesa-dri)");
  return {};
}

EGLDisplay open_display() {
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
  }
  const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
  return EGL_NO_DISPLAY;
}

EGLContext open_context(EGLDisplay display) {
  // Highest version first: some drivers give exactly the requested version.
  constexpr std::array<std::array<int, 2>, 3> kVersions{{{4, 5}, {4, 1}, {3, 3}}};
  // One that tells of the driver's resets, if it can be had: with others some drivers end the program.
  for (const bool told : {true, false})
    for (const auto& [major, minor] : kVersions) {
      const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                   major,
                                   EGL_CONTEXT_MINOR_VERSION,
                                   minor,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                   told ? EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY : EGL_NONE,
                                   EGL_LOSE_CONTEXT_ON_RESET,
                                   EGL_NONE};
      const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
      if (context != EGL_NO_CONTEXT) return context;
    }
  return EGL_NO_CONTEXT;
}

class EglContext : public HeadlessContext {
 public:
  explicit EglContext(EGLDisplay display) : display_(display) {}
  ~EglContext() override;
  base::Result<void> open();
  base::Result<void> make_current() override;
  void release() override;

 private:
  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
  bool current_ = false;
};

EglContext::~EglContext() {
  if (current_) EglContext::release();
  if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

base::Result<void> EglContext::open() {
  if (!eglBindAPI(EGL_OPENGL_API)) return none(tr("EGL has no desktop OpenGL: install Mesa (Debian: libgl1-mesa-dri)"));
  context_ = open_context(display_);
  if (context_ == EGL_NO_CONTEXT)
    return none(
        tr("OpenGL 3.3 core is not available: update the graphics driver, or use Mesa's software renderer "
           "(LIBGL_ALWAYS_SOFTWARE=1)"));
  return {};
}

base::Result<void> EglContext::make_current() {
  eglBindAPI(EGL_OPENGL_API);  // of this thread
  if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
    return none(tr("the OpenGL context cannot be used without a window: update the graphics driver"));
  current_ = true;
  return {};
}

void EglContext::release() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  current_ = false;
}

}  // namespace

HeadlessContext::Opened open_egl() {
  if (std::string missing = missing_library(); !missing.empty()) return none(std::move(missing));
  const EGLDisplay display = open_display();
  if (display == EGL_NO_DISPLAY)
    return none(tr("no EGL display: install a graphics driver (Debian: libegl1 and libgl1-mesa-dri)"));
  auto context = std::make_unique<EglContext>(display);
  if (const auto opened = context->open(); !opened) return base::failed(opened);
  return context;
}

}  // namespace weftlight::gl
