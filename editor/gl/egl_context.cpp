// EGL without a surface: graphics cards first, then Mesa's surfaceless platform (llvmpipe too), then the default
// display. Where a card's own driver stands beside Mesa, the surfaceless platform would be Mesa's and draw in software.

#include "gl/egl_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"
#include "platform/environment_variables.h"
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

bool initialized(EGLDisplay display) {
  return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE;
}

/// Mesa's own wish for software. Another driver does not know it, so its card is left alone.
bool software_is_wanted() {
  const std::string wish = platform::variable("LIBGL_ALWAYS_SOFTWARE");
  return wish == "1" || wish == "true";
}

bool is_software(EGLDeviceEXT device) {
  const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
  return extensions && std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos;
}

std::vector<EGLDisplay> displays_of_cards() {
  if (software_is_wanted() || !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") ||
      !(epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_base") ||
        (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") &&
         epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_query"))))
    return {};
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (!eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count)) return {};
  std::vector<EGLDisplay> displays;
  for (EGLint k = 0; k < count; ++k)
    if (const EGLDeviceEXT device = devices[static_cast<size_t>(k)]; !is_software(device))
      displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
  return displays;
}

/// In the order in which they are tried; some may not work.
std::vector<EGLDisplay> displays() {
  std::vector<EGLDisplay> all = displays_of_cards();
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
    all.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  all.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
  return all;
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
  base::Failure why = none(tr("no EGL display: install a graphics driver (Debian: libegl1 and libgl1-mesa-dri)"));
  for (const EGLDisplay display : displays()) {
    if (!initialized(display)) continue;
    auto context = std::make_unique<EglContext>(display);
    const auto opened = context->open();
    if (opened) return context;
    why = base::failed(opened);
  }
  return why;
}

}  // namespace weftlight::gl
