#pragma once
// Identifies the content of a file as it was read or written, so that changes by another program are noticed before
// they are overwritten.

#include <cstdint>
#include <string>
#include <string_view>

#include "base/hash.h"

namespace weftlight::session {

struct FileIdentity {
  bool there = false;
  uint64_t device = 0, inode = 0, size = 0;
  int64_t modified_ns = 0;  // since 1970
  uint64_t hash = 0;        // of the content (base/hash.h)
  bool operator==(const FileIdentity&) const = default;
};

/// Everything except the hash, without reading the file.
FileIdentity facts_of(const std::string& path);
/// Of the file at `path` as it is now, following symbolic links; reads all of it. `there` is false if it is unreadable.
FileIdentity identify(const std::string& path);
/// The same for a file whose content is known to be `bytes`.
FileIdentity identify(const std::string& path, std::string_view bytes);

enum class FileChange { kNone, kContent, kGone };
/// How the file changed since it was `known`. Cheap while size, time and inode are the same; otherwise the content
/// decides, and `known` gets the new time if the content is the same.
FileChange changed_since(const std::string& path, FileIdentity& known);

/// True if both are one file on one disk, unchanged in size and time; its names may differ. No disk is asked.
bool is_one_file(const FileIdentity& a, const FileIdentity& b);
/// True if both paths name one file, links apart. No disk is asked.
bool is_same_name(const std::string& a, const std::string& b);

}  // namespace weftlight::session
