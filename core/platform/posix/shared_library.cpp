#include "platform/shared_library.h"

#include <dlfcn.h>

namespace weftlight::platform {

bool has_library(const char* name) { return ::dlopen(name, RTLD_LAZY | RTLD_LOCAL) != nullptr; }

void* function_of_library(const std::string& path, const char* function, std::string& problem) {
  void* library = ::dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
  void* found = library != nullptr ? ::dlsym(library, function) : nullptr;
  if (found == nullptr) {
    const char* error = ::dlerror();
    problem = error != nullptr ? error : function;
  }
  return found;
}

}  // namespace weftlight::platform
