#include "platform/shared_library.h"

#include <dlfcn.h>

namespace weftlight::platform {

bool has_library(const char* name) { return ::dlopen(name, RTLD_LAZY | RTLD_LOCAL) != nullptr; }

}  // namespace weftlight::platform
