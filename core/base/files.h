#pragma once
// Whole files in and out, with errors in words. Writing is atomic (platform/durable_file.h): the old file is there or
// the new one. Functions that write return an empty string, or the file and the problem ("cloth.png: cannot be written:
// the disk is full").

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <system_error>

namespace weftlight::base {

inline constexpr uint64_t kMaxFileBytes = uint64_t{1} << 30;

struct FileBytes {
  std::string bytes, error;  // the error does not name the file
};
/// Reads a regular file. Pipes, devices and files larger than `max_bytes` are errors; it never waits for a writer. A
/// request to stop is one, too, once the system gives the bytes asked for last: a share may keep them for ever.
FileBytes read_file(const std::string& path, uint64_t max_bytes = kMaxFileBytes, const std::stop_token& stop = {});

/// Follows symbolic links, keeps the permissions of the old file, and fails on read-only files. Devices, pipes and the
/// standard streams are written directly.
std::string write_file_atomically(const std::string& path, std::string_view bytes);
/// The same for libraries that write files themselves: `write` gets the name of a temporary file with the same
/// extension, and returns or throws the problem.
using WriteFile = std::function<std::string(const std::string& beside)>;
std::string write_through(const std::string& path, const WriteFile& write);
/// Why `path` cannot be written, in the words of write_through(), or empty. For a check before long work.
std::string why_not_writable(const std::string& path);

/// The text for an error of writing a file ("the disk is full"); the second for errno, which C streams set.
std::string cause_of(const std::error_code& error);
std::string cause_of(int error_number);

}  // namespace weftlight::base
