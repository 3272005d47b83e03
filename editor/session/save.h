#pragma once
// A save: what it needs is taken at once, the writing may take its time on another thread.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "design/history.h"
#include "session/files/file_identity.h"

namespace weftlight::session {

struct SaveJob {
  uint64_t document = 0;
  std::string path;
  std::function<std::string()> text;      // makes the bytes
  design::History::Mark mark = {};        // of what they hold
  std::string own_path = {};              // the document's file, empty without one,
  FileIdentity own_file = {};             // as it was read or written last
  bool over_changes = false;              // written also if another program changed that file since
  std::vector<FileIdentity> others = {};  // the files of the other open documents, which are not written over
};

struct Saved {
  bool changed = false;  // not written, since another program changed the file
  std::string path;      // of the file: the document's own where the path of the job is another name of it
  FileIdentity file;     // as it was written
};
using SaveResult = base::Result<Saved>;
inline bool is_written(const SaveResult& result) { return result && !result->changed; }

/// Writes the file, flushed to the disk; an error of kind kOutput also where it is open as another document. Callable
/// from any thread.
SaveResult write(const SaveJob& job);

}  // namespace weftlight::session
