#pragma once
// A zip of stored files: what .u3ma and .usdz ask for and general zip libraries do not promise (names flagged as UTF-8
// even when plain, FAT as the system, no extra fields, data aligned to 64 bytes for .usdz). The same files give the
// same bytes. Images are compressed already, so nothing is lost.

#include <string>
#include <vector>

#include "files/names.h"

namespace weftlight::files {

struct ZipEntry {
  std::string name;  // in the archive, with '/' between folders
  std::string path;  // of the file
};
enum class ZipKind { kPlain, kU3ma, kUsdz };

/// Writes the archive beside `path` and renames it into place. Sizes end at 4 GB. Empty: done; else what went wrong.
std::string write_zip(const std::string& path, const std::vector<ZipEntry>& entries, ZipKind kind);

}  // namespace weftlight::files
