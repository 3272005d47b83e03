#pragma once
// A context without a window or a display, through EGL (GPU or llvmpipe). Built where CMake finds EGL.

#include "gl/headless_context.h"

namespace weftlight::gl {

/// Current on no thread. On any thread.
HeadlessContext::Opened open_egl();

}  // namespace weftlight::gl
