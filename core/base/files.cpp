#include "base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <exception>
#include <filesystem>
#include <optional>
#include <system_error>

namespace weftlight::base {
namespace fs = std::filesystem;

namespace {

constexpr size_t kLongestStem = 150, kLongestEnding = 50;  // of a temporary's name, whose bytes end at 255

std::string not_written(const std::string& path, const std::string& cause) {
  return path + ": cannot be written: " + cause;
}

/// A descriptor that is closed once; closing may be the first to tell of a full disk.
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

/// 0, or the errno of what failed. What cannot be flushed (a pipe, a terminal) need not be.
int write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  return ::fsync(fd) != 0 && errno != EINVAL && errno != EROFS && errno != ENOTSUP ? errno : 0;
}

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

/// The descriptor that a name stands for: a stream that is open already goes on where it is.
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

/// A renamed file is there after a power cut only when its folder is flushed too.
void flush_folder_of(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.ok()) ::fsync(opened.get());
}

/// Gives the file beside the permissions of the one it replaces, flushes it and renames it. 0, or errno.
int put_in_place(const std::string& beside, const fs::path& target, std::optional<mode_t> mode) {
  Descriptor file(::open(beside.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.ok()) return errno;
  if (mode && ::fchmod(file.get(), *mode & 07777u) != 0) return errno;
  if (::fsync(file.get()) != 0 && errno != EINVAL && errno != EROFS) return errno;
  if (!file.close() || ::rename(beside.c_str(), target.c_str()) != 0) return errno;
  flush_folder_of(target);
  return 0;
}

std::string written_by(const WriteFile& write, const std::string& beside) {
  try {
    return write(beside);
  } catch (const std::exception& problem) {
    const std::string words = problem.what();
    return words.empty() ? "it cannot be made" : words;
  }
}

/// A pipe or a device takes bytes in their order: a library's file is made elsewhere and sent whole.
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

struct Target {
  fs::path path;
  std::optional<mode_t> mode;  // of the file that is there
  bool special = false;        // no file: a device, a pipe, a stream
  std::string error;
};

Target target_at(const std::string& path) {
  struct stat old {};
  const bool there = ::stat(path.c_str(), &old) == 0;
  if (open_stream(path) || (there && !S_ISREG(old.st_mode) && !S_ISDIR(old.st_mode))) return {path, {}, true, {}};
  if (path.empty()) return {{}, {}, false, "no file is named"};
  if (there && S_ISDIR(old.st_mode)) return {{}, {}, false, path + ": is a folder; give the name of a file"};
  Target target{target_of(path), {}, false, {}};
  if (!there) return target;
  // Renaming would replace what is read-only without asking; so would root.
  const bool for_nobody = (old.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0;
  if (for_nobody || ::access(target.path.c_str(), W_OK) != 0)
    target.error = not_written(path, cause_of(for_nobody ? EACCES : errno));
  target.mode = old.st_mode;
  return target;
}

}  // namespace

std::string cause_of(int error_number) {
  switch (error_number) {
    case ENOSPC:
      return "the disk is full";
    case EDQUOT:
      return "the disk is full up to your quota";
    case EACCES:
    case EPERM:
      return "it is read-only, or its folder is (permission denied)";
    case EROFS:
      return "the disk is read-only";
    case ENOENT:
      return "its folder is not there";
    case ENOTDIR:
      return "its folder is a file";
    case EIO:
      return "the disk failed (input/output error)";
    case EFBIG:
      return "it is larger than files may be";
    case ENAMETOOLONG:
      return "its name is too long";
    default:
      return std::generic_category().message(error_number);
  }
}

FileBytes read_file(const std::string& path, uint64_t most) {
  // Opening a pipe waits for its writer, unless asked not to.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.ok()) return {{}, errno == ENOENT ? "there is no such file" : "cannot be opened: " + cause_of(errno)};
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) return {{}, "cannot be read: " + cause_of(errno)};
  if (S_ISDIR(info.st_mode)) return {{}, "is a folder"};
  if (!S_ISREG(info.st_mode)) return {{}, "is a pipe or a device, not a file"};
  const std::string too_large = "is larger than " + std::to_string(most >> 20) + " MiB";
  if (static_cast<uint64_t>(info.st_size) > most) return {{}, too_large};
  FileBytes result;
  result.bytes.reserve(static_cast<size_t>(info.st_size));
  char buffer[65536];
  for (;;) {
    const ssize_t got = ::read(file.get(), buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return {{}, "cannot be read: " + cause_of(errno)};
    if (got == 0) return result;
    result.bytes.append(buffer, static_cast<size_t>(got));
    if (result.bytes.size() > most) return {{}, too_large};
  }
}

std::string temporary_beside(const std::string& path) {
  static std::atomic<unsigned> count{0};  // two threads of one process may write the same target
  const fs::path target(path);
  std::string name = target.stem().string().substr(0, kLongestStem);
  name.append(".part-").append(std::to_string(::getpid()));
  name.append("-").append(std::to_string(count++)).append(target.extension().string().substr(0, kLongestEnding));
  return (target.parent_path() / name).string();
}

std::string why_not_writable(const std::string& path) {
  const Target target = target_at(path);
  if (!target.error.empty()) return target.error;
  if (open_stream(path)) return {};
  const fs::path folder = target.path.has_parent_path() ? target.path.parent_path() : fs::path(".");
  const fs::path asked = target.special ? target.path : folder / ".";  // beside a file its temporary is made
  return ::access(asked.c_str(), W_OK) == 0 ? "" : not_written(path, cause_of(errno));
}

std::string write_through(const std::string& path, const WriteFile& write) {
  const Target target = target_at(path);
  if (!target.error.empty()) return target.error;
  if (target.special) return write_special(path, write);
  const std::string beside = temporary_beside(target.path.string());
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
    Descriptor file(::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!file.ok()) return cause_of(errno);
    if (const int failed = write_all(file.get(), bytes); failed != 0) return cause_of(failed);
    return file.close() ? "" : cause_of(errno);
  });
}

}  // namespace weftlight::base
