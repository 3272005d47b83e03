#pragma once
// Whole files in and out. Writing is atomic: the new file is written beside the old one, flushed to the disk and
// renamed into place. Functions that write return an empty string, or the file and the problem ("cloth.png: cannot be
// written: the disk is full").

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace weftlight::base {

inline constexpr uint64_t kMaxFileBytes = uint64_t{1} << 30;

struct FileBytes {
  std::string bytes, error;  // the error does not name the file
};
/// Reads a regular file. Pipes, devices and files larger than `max_bytes` are errors; it never waits.
FileBytes read_file(const std::string& path, uint64_t max_bytes = kMaxFileBytes);

/// Follows symbolic links, keeps the permissions of the old file, and fails on read-only files. Devices, pipes and the
/// standard streams are written directly.
std::string write_file_atomically(const std::string& path, std::string_view bytes);
/// The same for libraries that write files themselves: `write` gets the name of a temporary file with the same
/// extension, and returns or throws the problem.
using WriteFile = std::function<std::string(const std::string& beside)>;
std::string write_through(const std::string& path, const WriteFile& write);
/// Why `path` cannot be written, in the words of write_through(), or empty. For a check before long work.
std::string why_not_writable(const std::string& path);

/// A unique name beside `path`, on any machine, with the same extension: "STEM.part-RANDOM.EXT". The file is locked
/// (platform/file_lock.h) while its owner lives; only that tells what a killed process left.
std::string temporary_beside(const std::string& path);
/// Whether `name`, without its folder, is one that temporary_beside(path) gives.
bool is_temporary_of(const std::string& path, const std::string& name);
/// The text for an errno of writing a file ("the disk is full").
std::string cause_of(int error_number);

}  // namespace weftlight::base
