#pragma once
// Files that are either the old ones or the new ones, never half of each: written beside the target,
// flushed to the disk, renamed into place. Every function returns an empty string or what went wrong.

#include <span>
#include <string>

#include "files/names.h"

namespace weftlight::files {

/// A name beside `path` that no other process uses, with the same extension (writers choose the format by it).
std::string temporary_beside(const std::string& path);
/// Flushes `temporary` to the disk and renames it to `path`; removes it when that fails.
std::string commit_file(const std::string& temporary, const std::string& path);
/// Whole file from bytes.
std::string write_bytes(const std::string& path, std::span<const unsigned char> bytes);
std::string write_text(const std::string& path, const std::string& text);

}  // namespace weftlight::files
