// EGL without a surface: Mesa's surfaceless platform first (a GPU or llvmpipe), then the default display
// of the vendor's driver.

#include "gl/context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <initializer_list>

#include "base/text.h"

namespace weftlight::gl {

using base::tr;

namespace {

bool loads(std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [](const char* name) {
    void* library = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
    return library != nullptr;  // kept open: libepoxy loads the same one next
  });
}

/// libepoxy exits the program if a library that it loads is missing.
std::string missing_library() {
#ifdef __linux__
  if (!loads({"libEGL.so.1"})) return tr("libEGL.so.1 is not there: install it (Debian: libegl1 and libgl1-mesa-dri)");
  if (!loads({"libOpenGL.so.0", "libGL.so.1"}))
    return tr("libGL.so.1 is not there: install it (Debian: libgl1 and libgl1-mesa-dri)");
#endif
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
  // A driver that tells of its resets; otherwise some end the program with a reset.
  for (const EGLint resets : {EGL_LOSE_CONTEXT_ON_RESET, EGL_NO_RESET_NOTIFICATION})
    for (const auto& [major, minor] : kVersions) {
      const bool told = resets == EGL_LOSE_CONTEXT_ON_RESET;
      const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                   major,
                                   EGL_CONTEXT_MINOR_VERSION,
                                   minor,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                   told ? EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY : EGL_NONE,
                                   resets,
                                   EGL_NONE};
      const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
      if (context != EGL_NO_CONTEXT) return context;
    }
  return EGL_NO_CONTEXT;
}

}  // namespace

base::Result<std::unique_ptr<HeadlessContext>> HeadlessContext::create() {
  const auto none = [](std::string why) { return base::failure(base::ErrorKind::kGraphics, std::move(why)); };
  if (std::string missing = missing_library(); !missing.empty()) return none(std::move(missing));
  std::unique_ptr<HeadlessContext> made(new HeadlessContext);
  const EGLDisplay display = open_display();
  if (display == EGL_NO_DISPLAY)
    return none(tr("no EGL display: install a graphics driver (Debian: libegl1 and libgl1-mesa-dri)"));
  made->display_ = display;
  if (!eglBindAPI(EGL_OPENGL_API)) return none(tr("EGL has no desktop OpenGL: install Mesa (Debian: libgl1-mesa-dri)"));
  const EGLContext context = open_context(display);
  if (context == EGL_NO_CONTEXT)
    return none(
        tr("OpenGL 3.3 core is not there: update the graphics driver, or use Mesa's software renderer "
           "(LIBGL_ALWAYS_SOFTWARE=1)"));
  made->context_ = context;
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
    return none(tr("the OpenGL context cannot be used without a window: update the graphics driver"));
  made->watch_.emplace();
  return made;
}

bool HeadlessContext::is_lost() const { return watch_ && watch_->is_lost(); }

// libepoxy ends the program where a function is called that the driver does not have.
ResetWatch::ResetWatch() : can_ask_(epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_KHR_robustness")) {}

bool ResetWatch::is_lost() const { return can_ask_ && glGetGraphicsResetStatus() != GL_NO_ERROR; }

HeadlessContext::~HeadlessContext() {
  if (!display_) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (context_) eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

}  // namespace weftlight::gl
