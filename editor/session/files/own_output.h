#pragma once
// The files that the flags --live-export and --ui-map keep up to date. They are replaced without a question, so only if
// there is no file or the same flag wrote it.

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"

namespace weftlight::session {

/// The file of --live-export. It looks like any other draft, so the hashes of the last writes are recorded in the
/// user's state folder.
class LiveExport {
 public:
  LiveExport(std::string path, const std::string& state_folder);
  const std::string& path() const { return path_; }
  /// An error if the file may not be written while these drafts are open.
  base::Result<void> check(const std::vector<std::string>& drafts) const;
  base::Result<void> write(std::string_view bytes);

 private:
  std::string path_, record_;
  uint64_t last_ = 0;  // hash of the last write
};

/// The same for --ui-map, which is recognised by its content.
base::Result<void> check_ui_map(const std::string& path, const std::vector<std::string>& drafts);

}  // namespace weftlight::session
