#pragma once
// A zip archive of stored files, with properties that .u3ma and .usdz need and general zip libraries do not guarantee:
// names flagged as UTF-8, FAT as the system, no extra fields, data aligned to 64 bytes for .usdz. The same files give
// the same bytes. Compression would gain nothing, since images are compressed already.

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"

namespace weftlight::files {

struct ZipEntry {
  std::string name;  // in the archive, with '/' between folders
  std::string path;  // of the file
};
enum class ZipKind { kPlain, kU3ma, kUsdz };

/// Size in bytes of a plain archive of these files; a file that cannot be read counts as empty.
uint64_t plain_zip_size(const std::vector<ZipEntry>& entries);

/// Writes the archive atomically; at most 4 GB.
base::Result<void> write_zip(const std::string& path, const std::vector<ZipEntry>& entries, ZipKind kind);

}  // namespace weftlight::files
