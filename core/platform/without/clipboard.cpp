// A clipboard on which the window library cannot hang.

#include "platform/clipboard.h"

namespace weftlight::platform {

ClipboardText clipboard_text(void* /*window*/) { return {}; }

}  // namespace weftlight::platform
