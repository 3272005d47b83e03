#include "base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "base/caught.h"
#include "base/text.h"
#include "platform/file_lock.h"
#include "platform/unique_name.h"

namespace weftlight::base {
namespace fs = std::filesystem;

namespace {

constexpr size_t kMaxStem = 150, kMaxExtension = 50;  // bytes of a temporary name, which may have at most 255

std::string not_read(int error_number) {
  return fill(tr("cannot be read: {cause}"), arg("cause", cause_of(error_number)));
}

std::string not_written(const std::string& path, const std::string& cause) {
  return fill(tr("{file}: cannot be written: {cause}"), arg("file", path), arg("cause", cause));
}

/// A file descriptor that is closed once. A full disk may be reported only by close().
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }
  bool ok() const { return fd_ >= 0; }
  bool close() {
    const int fd = fd_;
    fd_ = -1;
    return fd < 0 || ::close(fd) == 0;
  }

 private:
  int fd_;
};

/// Returns 0 or errno. Pipes and terminals cannot be flushed, which is no error.
int write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  return ::fsync(fd) != 0 && errno != EINVAL && errno != EROFS && errno != ENOTSUP ? errno : 0;
}

/// The file at the end of a chain of symbolic links; it need not exist.
fs::path link_target(fs::path path) {
  constexpr int kMaxLinks = 32;
  std::error_code error;
  for (int i = 0; i < kMaxLinks && fs::is_symlink(path, error); ++i) {
    const fs::path next = fs::read_symlink(path, error);
    if (error) break;
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  return path;
}

/// The descriptor of a name such as /dev/stdout: an open stream continues at its position.
std::optional<int> open_stream(const std::string& path) {
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

std::string write_in_place(const std::string& path, std::string_view bytes) {
  const std::optional<int> stream = open_stream(path);
  Descriptor file(stream ? ::dup(*stream) : ::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!file.ok()) return not_written(path, cause_of(errno));
  if (const int failed = write_all(file.get(), bytes); failed != 0) return not_written(path, cause_of(failed));
  return file.close() ? "" : not_written(path, cause_of(errno));
}

/// A rename survives a power failure only if the folder is flushed too.
void flush_folder_of(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.ok()) ::fsync(opened.get());
}

/// Gives the temporary file the permissions of the one that it replaces, flushes it and renames it. Returns 0 or errno.
int put_in_place(const std::string& beside, const fs::path& target, std::optional<mode_t> mode) {
  Descriptor file(::open(beside.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.ok()) return errno;
  if (mode && ::fchmod(file.get(), *mode & 07777u) != 0) return errno;
  if (::fsync(file.get()) != 0 && errno != EINVAL && errno != EROFS) return errno;
  if (!file.close() || ::rename(beside.c_str(), target.c_str()) != 0) return errno;
  flush_folder_of(target);
  return 0;
}

/// What a temporary's name begins and ends with.
std::pair<std::string, std::string> around_mark(const fs::path& target) {
  return {target.stem().string().substr(0, kMaxStem) + ".part-", target.extension().string().substr(0, kMaxExtension)};
}

/// An empty file beside `target` and its lock.
struct Beside {
  std::string path;
  platform::FileLock lock;
  int failed = 0;  // errno
};
Beside make_beside(const std::string& target) {
  using platform::LockAnswer;
  constexpr int kMaxTries = 10;
  for (int i = 0; i < kMaxTries; ++i) {
    Beside made{temporary_beside(target), {}, 0};
    made.lock = platform::FileLock::make(made.path);
    made.failed = made.lock.answer() == LockAnswer::kNoFile ? made.lock.cause() : 0;
    if (made.failed != 0 && made.failed != EEXIST) return made;
    // A process that removes stale files may come between a file and its lock.
    if (made.lock.answer() == LockAnswer::kNoLocks || (made.lock.held() && made.lock.stands_at(made.path))) return made;
  }
  return {{}, {}, EBUSY};
}

std::string written_by(const WriteFile& write, const std::string& beside) {
  try {
    return write(beside);
  } catch (...) {
    return words_of_thrown();
  }
}

/// Pipes and devices need their bytes in order, so the library writes a temporary file first.
std::string write_special(const std::string& path, const WriteFile& write) {
  std::error_code error;
  const std::string made = temporary_beside((fs::temp_directory_path(error) / fs::path(path).filename()).string());
  std::string problem = written_by(write, made);
  if (!problem.empty()) problem = not_written(path, problem);
  if (problem.empty()) {
    const FileBytes file = read_file(made);
    problem = file.error.empty() ? write_in_place(path, file.bytes) : not_written(path, file.error);
  }
  ::unlink(made.c_str());
  return problem;
}

struct Destination {
  fs::path path;
  std::optional<mode_t> mode;  // of an existing file
  bool special = false;        // a device, a pipe or a stream
  std::string error;
};

Destination destination_at(const std::string& path) {
  struct stat old {};
  const bool there = ::stat(path.c_str(), &old) == 0;
  if (open_stream(path) || (there && !S_ISREG(old.st_mode) && !S_ISDIR(old.st_mode))) return {path, {}, true, {}};
  if (path.empty()) return {{}, {}, false, tr("no file name is given")};
  if (there && S_ISDIR(old.st_mode))
    return {{}, {}, false, fill(tr("{file}: is a folder; give the name of a file"), arg("file", path))};
  Destination target{link_target(path), {}, false, {}};
  if (!there) return target;
  // A rename would replace a read-only file without an error, and root may write everything.
  const bool read_only = (old.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0;
  if (read_only || ::access(target.path.c_str(), W_OK) != 0)
    target.error = not_written(path, cause_of(read_only ? EACCES : errno));
  target.mode = old.st_mode;
  return target;
}

}  // namespace

std::string cause_of(int error_number) {
  switch (error_number) {
    case ENOSPC:
      return tr("the disk is full");
    case EDQUOT:
      return tr("your quota of the disk is full");
    case EACCES:
    case EPERM:
      return tr("it or its folder is read-only (permission denied)");
    case EROFS:
      return tr("the disk is read-only");
    case ENOENT:
      return tr("its folder does not exist");
    case ENOTDIR:
      return tr("its folder is a file");
    case EIO:
      return tr("the disk failed (input/output error)");
    case EFBIG:
      return tr("it is larger than the system allows");
    case ENAMETOOLONG:
      return tr("its name is too long");
    default:
      return std::generic_category().message(error_number);
  }
}

FileBytes read_file(const std::string& path, uint64_t max_bytes) {
  // Without O_NONBLOCK, opening a pipe would wait for its writer.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.ok())
    return {{},
            errno == ENOENT ? tr("there is no such file")
                            : fill(tr("cannot be opened: {cause}"), arg("cause", cause_of(errno)))};
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) return {{}, not_read(errno)};
  if (S_ISDIR(info.st_mode)) return {{}, tr("is a folder")};
  if (!S_ISREG(info.st_mode)) return {{}, tr("is a pipe or a device, not a file")};
  const std::string too_large = fill(tr("is larger than {size} MiB"), arg("size", max_bytes >> 20));
  if (static_cast<uint64_t>(info.st_size) > max_bytes) return {{}, too_large};
  FileBytes result;
  result.bytes.reserve(static_cast<size_t>(info.st_size));
  char buffer[65536];
  for (;;) {
    const ssize_t got = ::read(file.get(), buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return {{}, not_read(errno)};
    if (got == 0) return result;
    result.bytes.append(buffer, static_cast<size_t>(got));
    if (result.bytes.size() > max_bytes) return {{}, too_large};
  }
}

std::string temporary_beside(const std::string& path) {
  const auto [start, ending] = around_mark(path);
  return (fs::path(path).parent_path() / (start + platform::unique_name() + ending)).string();
}

bool is_temporary_of(const std::string& path, const std::string& name) {
  const auto [start, ending] = around_mark(path);
  if (name.size() < start.size() + ending.size() || !name.starts_with(start) || !name.ends_with(ending)) return false;
  const std::string_view mark(name);
  return platform::is_unique_name(mark.substr(start.size(), name.size() - start.size() - ending.size()));
}

std::string why_not_writable(const std::string& path) {
  const Destination target = destination_at(path);
  if (!target.error.empty()) return target.error;
  if (open_stream(path)) return {};
  const fs::path folder = target.path.has_parent_path() ? target.path.parent_path() : fs::path(".");
  const fs::path asked = target.special ? target.path : folder / ".";  // a temporary file is made in the folder
  return ::access(asked.c_str(), W_OK) == 0 ? "" : not_written(path, cause_of(errno));
}

std::string write_through(const std::string& path, const WriteFile& write) {
  const Destination target = destination_at(path);
  if (!target.error.empty()) return target.error;
  if (target.special) return write_special(path, write);
  const Beside made = make_beside(target.path.string());
  if (made.failed != 0) return not_written(path, cause_of(made.failed));
  const std::string& beside = made.path;
  std::string problem = written_by(write, beside);
  if (problem.empty()) {
    if (const int failed = put_in_place(beside, target.path, target.mode); failed != 0) problem = cause_of(failed);
  }
  if (problem.empty()) return {};
  ::unlink(beside.c_str());
  return not_written(path, problem);
}

std::string write_file_atomically(const std::string& path, std::string_view bytes) {
  struct stat info {};
  if (open_stream(path) || (::stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode))) {
    return write_in_place(path, bytes);
  }
  return write_through(path, [bytes](const std::string& beside) -> std::string {
    Descriptor file(::open(beside.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
    if (!file.ok()) return cause_of(errno);
    if (const int failed = write_all(file.get(), bytes); failed != 0) return cause_of(failed);
    return file.close() ? "" : cause_of(errno);
  });
}

}  // namespace weftlight::base
