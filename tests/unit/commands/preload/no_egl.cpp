// Loaded before a program, hides libEGL from it as on a system without one.

#include <dlfcn.h>

#include <cstring>

extern "C" void* dlopen(const char* name, int flags) noexcept {
  if (name && std::strstr(name, "libEGL")) return nullptr;
  return reinterpret_cast<void* (*)(const char*, int)>(dlsym(RTLD_NEXT, "dlopen"))(name, flags);
}
