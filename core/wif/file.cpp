// Whole files in and out. A file is replaced by rename, so that a crash or a full disk leaves the old one.

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "wif/wif.h"

namespace weftlight::wif {
namespace {

namespace fs = std::filesystem;

std::string why(const std::string& doing) { return doing + ": " + std::strerror(errno); }

/// The file a chain of symbolic links ends at, which may not be there yet.
fs::path target_of(fs::path path) {
  constexpr int kMaxLinks = 32;
  std::error_code error;
  for (int i = 0; i < kMaxLinks && fs::is_symlink(path, error); ++i) {
    const fs::path next = fs::read_symlink(path, error);
    if (error) break;
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  return path;
}

/// Empty string: all bytes are written and on the disk.
std::string write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return why("cannot write");
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  if (::fsync(fd) != 0 && errno != EINVAL && errno != EROFS) return why("cannot write to the disk");
  return {};
}

int open_temporary(const fs::path& target, fs::path& temporary) {
  constexpr int kTries = 1000;
  for (int i = 0; i < kTries; ++i) {
    temporary = target;
    std::string name = ".";
    name.append(target.filename().string())
        .append(".")
        .append(std::to_string(::getpid()))
        .append("-")
        .append(std::to_string(i));
    temporary.replace_filename(name);
    const int fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0 || errno != EEXIST) return fd;
  }
  return -1;
}

/// /dev/stdout and the like are written in place.
std::string write_in_place(const fs::path& target, std::string_view bytes) {
  const int fd = ::open(target.c_str(), O_WRONLY | O_CLOEXEC);
  if (fd < 0) return why("cannot open " + target.string());
  std::string error = write_all(fd, bytes);
  if (::close(fd) != 0 && error.empty()) error = why("cannot close " + target.string());
  return error;
}

}  // namespace

FileBytes read_file(const std::string& path) {
  FileBytes result;
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return {{}, why("cannot open")};
  struct stat info {};
  if (::fstat(fd, &info) == 0 && S_ISREG(info.st_mode) && info.st_size > 0) {
    result.bytes.reserve(static_cast<size_t>(info.st_size));
  }
  char buffer[65536];
  for (;;) {
    const ssize_t got = ::read(fd, buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) result = {{}, why("cannot read")};
    if (got <= 0) break;
    result.bytes.append(buffer, static_cast<size_t>(got));
  }
  ::close(fd);
  return result;
}

std::string write_file_atomically(const std::string& path, std::string_view bytes) {
  const fs::path target = target_of(path);
  struct stat old {};
  const bool there = ::stat(target.c_str(), &old) == 0;
  if (there && S_ISDIR(old.st_mode)) return target.string() + " is a folder";
  if (there && !S_ISREG(old.st_mode)) return write_in_place(target, bytes);
  if (there && ::access(target.c_str(), W_OK) != 0) return why("cannot write " + target.string());
  fs::path temporary;
  const int fd = open_temporary(target, temporary);
  if (fd < 0) return why("cannot write in the folder of " + target.string());
  std::string error = write_all(fd, bytes);
  if (error.empty() && there && ::fchmod(fd, old.st_mode & 07777) != 0) error = why("cannot keep the permissions");
  if (::close(fd) != 0 && error.empty()) error = why("cannot close");
  if (error.empty() && ::rename(temporary.c_str(), target.c_str()) != 0)
    error = why("cannot replace " + target.string());
  if (!error.empty()) {
    ::unlink(temporary.c_str());
    return error;
  }
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const int folder_fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder_fd >= 0) {
    ::fsync(folder_fd);
    ::close(folder_fd);
  }
  return {};
}

}  // namespace weftlight::wif
