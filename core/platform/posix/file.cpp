#include "platform/file.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

namespace weftlight::platform {
namespace {

std::error_code last_error() { return {errno, std::generic_category()}; }

FileFacts facts_from(const struct stat& info) {
  constexpr int64_t kNsPerS = 1'000'000'000;
#ifdef __APPLE__
  const timespec modified = info.st_mtimespec;
#else
  const timespec modified = info.st_mtim;
#endif
  FileFacts facts;
  facts.kind = S_ISREG(info.st_mode)   ? FileKind::kRegular
               : S_ISDIR(info.st_mode) ? FileKind::kFolder
                                       : FileKind::kStream;
  facts.volume = static_cast<uint64_t>(info.st_dev);
  facts.number = static_cast<uint64_t>(info.st_ino);
  facts.size = static_cast<uint64_t>(info.st_size);
  facts.modified_ns = static_cast<int64_t>(modified.tv_sec) * kNsPerS + modified.tv_nsec;
  return facts;
}

/// The descriptor of a name such as /dev/stdout.
std::optional<int> stream_named(const std::string& path) {
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (path.rfind(folder, 0) != 0) continue;
    int fd = -1;
    const char* end = path.data() + path.size();
    if (std::from_chars(path.data() + folder.size(), end, fd).ptr == end && fd >= 0) return fd;
  }
  return std::nullopt;
}

int flags_of(File::Open how) {
  switch (how) {
    case File::Open::kRead:
      return O_RDONLY | O_NONBLOCK;  // opening a pipe would wait for its writer
    case File::Open::kWrite:
      return O_WRONLY;
    case File::Open::kReplace:
      return O_WRONLY | O_TRUNC;
    case File::Open::kAppend:
      return O_WRONLY | O_APPEND;
    case File::Open::kCreate:
      return O_WRONLY | O_APPEND | O_CREAT | O_EXCL;
  }
  return O_RDONLY;
}

int open_file(const std::string& path, File::Open how) {
  if (how == File::Open::kWrite)
    if (const std::optional<int> stream = stream_named(path)) return ::fcntl(*stream, F_DUPFD_CLOEXEC, 0);
  return ::open(path.c_str(), flags_of(how) | O_CLOEXEC, 0600);
}

std::error_code sync_descriptor(int fd) {
  if (::fsync(fd) == 0 || errno == EINVAL || errno == EROFS || errno == ENOTSUP) return {};
  return last_error();
}

/// Of a folder that is open, or of the working folder. Asks for no memory of C++, so that what a job without memory
/// leaves can be removed.
std::error_code remove_in(int folder, const char* name) {
  struct stat info {};
  if (::fstatat(folder, name, &info, AT_SYMLINK_NOFOLLOW) != 0)
    return errno == ENOENT ? std::error_code() : last_error();
  if (!S_ISDIR(info.st_mode)) return ::unlinkat(folder, name, 0) == 0 ? std::error_code() : last_error();
  const int inner = ::openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  DIR* open = inner < 0 ? nullptr : ::fdopendir(inner);
  if (open == nullptr) {
    const std::error_code error = last_error();
    if (inner >= 0) ::close(inner);
    return error;
  }
  std::error_code error;
  for (errno = 0; const dirent* entry = error ? nullptr : ::readdir(open); errno = 0) {
    const std::string_view child = entry->d_name;
    if (child != "." && child != "..") error = remove_in(inner, entry->d_name);
  }
  if (!error && errno != 0) error = last_error();
  ::closedir(open);
  if (error) return error;
  return ::unlinkat(folder, name, AT_REMOVEDIR) == 0 ? std::error_code() : last_error();
}

}  // namespace

FileFacts file_facts(const std::string& path) {
  struct stat info {};
  return ::stat(path.c_str(), &info) == 0 ? facts_from(info) : FileFacts{};
}

File::File(const std::string& path, Open how) : handle_(open_file(path, how)) {
  if (handle_ < 0) error_ = last_error();
}

File::~File() { close(); }

FileFacts File::facts() const {
  struct stat info {};
  return ::fstat(static_cast<int>(handle_), &info) == 0 ? facts_from(info) : FileFacts{};
}

size_t File::read(char* to, size_t size, std::error_code& error) {
  for (;;) {
    const ssize_t got = ::read(static_cast<int>(handle_), to, size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) error = last_error();
    return got < 0 ? 0 : static_cast<size_t>(got);
  }
}

std::error_code File::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(static_cast<int>(handle_), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return last_error();
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  return {};
}

std::error_code File::sync() { return sync_descriptor(static_cast<int>(handle_)); }

std::error_code File::close() {
  const std::intptr_t handle = std::exchange(handle_, -1);
  return handle < 0 || ::close(static_cast<int>(handle)) == 0 ? std::error_code() : last_error();
}

std::FILE* open_stream(const std::string& path, const char* mode) { return std::fopen(path.c_str(), mode); }

bool is_open_stream(const std::string& path) { return stream_named(path).has_value(); }

std::error_code why_not_writable(const std::string& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return last_error();
  // root may write everything, a file that is read-only for all included.
  const bool read_only = S_ISREG(info.st_mode) && (info.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0;
  if (read_only) return std::make_error_code(std::errc::permission_denied);
  return ::access(path.c_str(), W_OK) == 0 ? std::error_code() : last_error();
}

std::vector<std::string> names_in(const std::string& folder, std::error_code& error) {
  error.clear();
  std::vector<std::string> names;
  const auto close = [](DIR* open) { ::closedir(open); };
  const std::unique_ptr<DIR, decltype(close)> open(::opendir(folder.c_str()), close);
  if (!open) return error = last_error(), names;
  for (;;) {
    errno = 0;
    const dirent* entry = ::readdir(open.get());
    if (entry == nullptr) break;
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") names.emplace_back(name);
  }
  if (errno != 0) error = last_error();
  return names;
}

std::error_code rename(const std::string& from, const std::string& to) {
  return std::rename(from.c_str(), to.c_str()) == 0 ? std::error_code() : last_error();
}

std::error_code remove_with_contents(const std::string& path) { return remove_in(AT_FDCWD, path.c_str()); }

std::error_code sync(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (fd < 0) return last_error();
  const std::error_code error = sync_descriptor(fd);
  ::close(fd);
  return error;
}

bool is_over_quota(const std::error_code& error) {
  return error.value() == EDQUOT &&
         (error.category() == std::generic_category() || error.category() == std::system_category());
}

void survive_size_limit() { std::signal(SIGXFSZ, SIG_IGN); }

}  // namespace weftlight::platform
