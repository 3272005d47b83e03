#pragma once
// A context of a window that is never shown, for systems without EGL. It needs a display; nothing is drawn into the
// window itself.

#include "gl/headless_context.h"

namespace weftlight::gl {

/// Current on no thread; any thread may make it current. To be opened and destroyed on the main thread.
HeadlessContext::Opened open_hidden_window();

}  // namespace weftlight::gl
