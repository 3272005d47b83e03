#pragma once
// Whole files in and out, with errors in words that name the file ("cloth.png: cannot be written: the disk is full").
// Writing is atomic (platform/durable_file.h): the old file is there or the new one.

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <system_error>

#include "base/result.h"

namespace weftlight::base {

inline constexpr uint64_t kMaxFileBytes = uint64_t{1} << 30;

/// The bytes of a regular file. Pipes, devices and files larger than `max_bytes` are errors; it never waits for a
/// writer. A request to stop is one, too, once the system gives the bytes asked for last: a share may keep them for
/// ever.
Result<std::string> read_file(const std::string& path, uint64_t max_bytes = kMaxFileBytes,
                              const std::stop_token& stop = {});

/// Follows symbolic links, keeps the permissions of the old file, and fails on read-only files. Devices, pipes and the
/// standard streams are written directly.
Result<void> write_file_atomically(const std::string& path, std::string_view bytes);
/// The same for libraries that write files themselves: `write` gets the name of a temporary file with the same
/// extension, and returns or throws the problem, without the name of the file.
using WriteFile = std::function<Result<void>(const std::string& beside)>;
Result<void> write_through(const std::string& path, const WriteFile& write);
/// What `write` returns where a library has only a text: done if it is empty.
Result<void> written_unless(std::string problem);
/// Whether `path` can be written, in the words of write_through(). For a check before long work.
Result<void> check_writable(const std::string& path);

/// The text for an error of writing a file ("the disk is full"); the second for errno, which C streams set.
std::string cause_of(const std::error_code& error);
std::string cause_of(int error_number);

}  // namespace weftlight::base
