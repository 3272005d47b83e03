// Loaded before a program: as long as the file $WEFTLIGHT_SLOW_DISK exists, files in its folder are neither flushed to
// the disk nor read. So a test decides how slow the disk is.

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <string>

namespace {

void wait_for_the_disk(int file) {
  static const std::string gate = [] {
    const char* named = std::getenv("WEFTLIGHT_SLOW_DISK");
    return std::string(named != nullptr ? named : "");
  }();
  static const std::string folder = gate.substr(0, gate.rfind('/') + 1);
  if (folder.empty() || access(gate.c_str(), F_OK) != 0) return;
  char path[4096] = {};
  const bool known = readlink(("/proc/self/fd/" + std::to_string(file)).c_str(), path, sizeof path - 1) > 0;
  while (known && std::strncmp(path, folder.c_str(), folder.size()) == 0 && access(gate.c_str(), F_OK) == 0)
    usleep(5000);
}

}  // namespace

extern "C" int fsync(int file) {
  wait_for_the_disk(file);
  return reinterpret_cast<int (*)(int)>(dlsym(RTLD_NEXT, "fsync"))(file);
}

extern "C" ssize_t read(int file, void* to, size_t bytes) {
  static const auto next = reinterpret_cast<ssize_t (*)(int, void*, size_t)>(dlsym(RTLD_NEXT, "read"));
  wait_for_the_disk(file);
  return next(file, to, bytes);
}
