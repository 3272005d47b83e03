#include "files/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace weftlight::files {
namespace fs = std::filesystem;

namespace {

std::string trouble(const std::string& what, const std::string& path) {
  return what + " " + path + ": " + std::strerror(errno);
}

}  // namespace

std::string temporary_beside(const std::string& path) {
  static std::atomic<unsigned> count{0};  // two threads of one process may write the same target
  const fs::path target(path);
  const std::string mark = ".part-" + std::to_string(::getpid()) + "-" + std::to_string(count++);
  return (target.parent_path() / (target.stem().string() + mark + target.extension().string())).string();
}

std::string commit_file(const std::string& temporary, const std::string& path) {
  std::string problem;
  const int file = ::open(temporary.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return trouble("cannot open", temporary);
  if (::fsync(file) != 0 && errno != EINVAL) problem = trouble("cannot flush", temporary);
  ::close(file);
  if (problem.empty() && std::rename(temporary.c_str(), path.c_str()) != 0) problem = trouble("cannot write", path);
  if (!problem.empty()) std::remove(temporary.c_str());
  return problem;
}

std::string write_bytes(const std::string& path, std::span<const unsigned char> bytes) {
  const std::string temporary = temporary_beside(path);
  std::FILE* file = std::fopen(temporary.c_str(), "wb");
  if (!file) return trouble("cannot write", path);
  const bool whole = bytes.empty() || std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const bool closed = std::fclose(file) == 0;
  if (!whole || !closed) {
    const std::string problem = trouble("cannot write", path);
    std::remove(temporary.c_str());
    return problem;
  }
  return commit_file(temporary, path);
}

std::string write_text(const std::string& path, const std::string& text) {
  return write_bytes(path, {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

}  // namespace weftlight::files
