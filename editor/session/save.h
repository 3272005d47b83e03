#pragma once
// A save: what it needs is taken at once, the writing may take its time on another thread.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "base/result.h"
#include "session/files/file_identity.h"

namespace weftlight::session {

struct SaveJob {
  uint64_t document = 0;
  std::string path;
  std::function<std::string()> text;  // makes the bytes
  uint64_t mark = 0;                  // of the step of the history that they hold
  std::optional<FileIdentity> known;  // only written if the file at `path` still is this one
};

struct Saved {
  bool changed = false;  // not written, since another program changed the file
  FileIdentity file;     // as it was written
};
using SaveResult = base::Result<Saved>;
inline bool is_written(const SaveResult& result) { return result && !result->changed; }

/// Writes the file, flushed to the disk. Callable from any thread.
SaveResult write(const SaveJob& job);

}  // namespace weftlight::session
