// Loaded before a program: as long as the file $WEFTLIGHT_SLOW_DISK exists, files in its folder are neither flushed to
// the disk nor read; with $WEFTLIGHT_DEAD_DISK set, questions about them are not answered either. So a test decides how
// slow the disk is.

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <string>

namespace {

const std::string& gate() {
  static const std::string path = [] {
    const char* named = std::getenv("WEFTLIGHT_SLOW_DISK");
    return std::string(named != nullptr ? named : "");
  }();
  return path;
}

bool is_shut() { return !gate().empty() && access(gate().c_str(), F_OK) == 0; }

void wait_for_the_disk(const char* path) {
  static const std::string folder = gate().substr(0, gate().rfind('/') + 1);
  while (std::strncmp(path, folder.c_str(), folder.size()) == 0 && is_shut()) usleep(5000);
}

void wait_for_the_disk(int file) {
  if (!is_shut()) return;
  char path[4096] = {};
  const bool known = readlink(("/proc/self/fd/" + std::to_string(file)).c_str(), path, sizeof path - 1) > 0;
  if (known) wait_for_the_disk(path);
}

/// Before a question about the file.
void wait_if_dead(const char* path) {
  static const bool dead = std::getenv("WEFTLIGHT_DEAD_DISK") != nullptr;
  if (dead && is_shut() && path != nullptr) wait_for_the_disk(path);
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

extern "C" int stat(const char* path, struct stat* facts) {
  wait_if_dead(path);
  return fstatat(AT_FDCWD, path, facts, 0);
}

extern "C" int lstat(const char* path, struct stat* facts) {
  wait_if_dead(path);
  return fstatat(AT_FDCWD, path, facts, AT_SYMLINK_NOFOLLOW);
}

extern "C" int stat64(const char* path, struct stat64* facts) {
  wait_if_dead(path);
  return fstatat64(AT_FDCWD, path, facts, 0);
}

extern "C" int lstat64(const char* path, struct stat64* facts) {
  wait_if_dead(path);
  return fstatat64(AT_FDCWD, path, facts, AT_SYMLINK_NOFOLLOW);
}
