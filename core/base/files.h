#pragma once
// Whole files in and out. A file that is written is the old one or the new one, never half of each: written
// beside it, flushed to the disk, renamed into place. Functions that write return an empty string, or the file
// and what went wrong with it ("cloth.png: cannot be written: the disk is full").

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace weftlight::base {

inline constexpr uint64_t kMaxFileBytes = uint64_t{1} << 30;

struct FileBytes {
  std::string bytes, error;  // the error does not name the file
};
/// Regular files only: a pipe or a device is refused and not waited for. Larger than `most` is refused.
FileBytes read_file(const std::string& path, uint64_t most = kMaxFileBytes);

/// Writes to the file that a link leads to, keeps the permissions of the old one, and refuses what is read-only.
/// Devices, pipes and the standard streams are written as they stand.
std::string write_file_atomically(const std::string& path, std::string_view bytes);
/// The same for libraries that write files themselves: `write` fills the file whose name it is given, which ends
/// in the same extension, and returns what went wrong or throws it.
using WriteFile = std::function<std::string(const std::string& beside)>;
std::string write_through(const std::string& path, const WriteFile& write);
/// Why `path` cannot be written, as those who write it would say, or empty: asked before work that takes long.
std::string why_not_writable(const std::string& path);

/// A name beside `path` that nobody else uses, with the same extension: "STEM.part-PROCESS-COUNT.EXT".
std::string temporary_beside(const std::string& path);
/// What errno says, in the words of one who saves a file ("the disk is full").
std::string cause_of(int error_number);

}  // namespace weftlight::base
