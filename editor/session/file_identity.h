#pragma once
// Which content a file had when it was read or written, so that another program's changes are noticed before they
// are overwritten.

#include <cstdint>
#include <string>
#include <string_view>

#include "session/names.h"

namespace weftlight::session {

/// FNV-1a of 64 bits (Fowler, Noll, Vo 1991): tells contents apart, and keeps nobody out. Of several pieces: each
/// `from` the hash of those before.
uint64_t content_hash(std::string_view bytes, uint64_t from = 0xcbf29ce484222325u);

struct FileIdentity {
  bool there = false;
  uint64_t device = 0, inode = 0, size = 0;
  int64_t modified_ns = 0;  // since 1970
  uint64_t hash = 0;        // of the content
  bool operator==(const FileIdentity&) const = default;
};

/// All but the hash, without reading the file.
FileIdentity facts_of(const std::string& path);
/// Of the file at `path` as it is now, through symbolic links; reads all of it. Not `there`: none that can be read.
FileIdentity identify(const std::string& path);
/// The same, of a file whose content is known to be `bytes`.
FileIdentity identify(const std::string& path, std::string_view bytes);

enum class FileChange { kNone, kContent, kGone };
/// What happened to the file since it was `known`. Cheap as long as size, time and inode are as they were; else
/// the content decides, and `known` takes up the new time when that is the same.
FileChange changed_since(const std::string& path, FileIdentity& known);

/// Whether both paths lead to one file, or would once it is there.
bool same_file(const std::string& a, const std::string& b);

}  // namespace weftlight::session
