#pragma once
// The files that the flags --live-export and --ui-map keep up to date: they are replaced without a question, so only
// where nothing stands or what stands was written by the same flag.

#include <cstdint>
#include <string>

#include "session/names.h"

namespace weftlight::session {

/// The file of --live-export. A draft that it writes looks like any other draft, so the hashes of what was written
/// last stand in the user's state folder.
class LiveExport {
 public:
  LiveExport(std::string path, const std::string& state_folder);
  const std::string& path() const { return path_; }
  /// Why it may not be written while `draft` is open (empty: none is): what is wrong and what to do; empty: it may.
  std::string rejected_edit(const std::string& draft) const;
  /// Writes it; what went wrong, or empty.
  std::string write(std::string_view bytes);

 private:
  std::string path_, record_;
  uint64_t last_ = 0;  // hash of what is there
};

/// The same of --ui-map, which is told from other files by what it says.
std::string ui_map_refusal(const std::string& path, const std::string& draft);

}  // namespace weftlight::session
