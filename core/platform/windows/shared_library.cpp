#include "platform/shared_library.h"

#include <windows.h>

#include "platform/windows/wide.h"

namespace weftlight::platform {

bool has_library(const char* name) { return ::LoadLibraryW(wide(name).c_str()) != nullptr; }

}  // namespace weftlight::platform
