#pragma once
// Opens a headless context: by EGL, which needs no display, else by a hidden window. The variable WEFTLIGHT_OFFSCREEN
// (egl, window, none) allows one of them alone, or neither.

#include <functional>

#include "gl/headless_context.h"

namespace weftlight::gl {

/// Makes a context current on this thread, which must be the main one: a window may be opened there alone.
HeadlessContext::Opened open_headless();
/// The same on any thread. `hidden_window` is called where EGL fails; it has the main thread open_hidden_window().
HeadlessContext::Opened open_headless(const std::function<HeadlessContext::Opened()>& hidden_window);

}  // namespace weftlight::gl
