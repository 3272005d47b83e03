#pragma once
// The files that the flags --live-export and --ui-map keep up to date. They are replaced without a question, so only if
// there is no file or the same flag wrote it.

#include <cstdint>
#include <string>

namespace weftlight::session {

/// The file of --live-export. It looks like any other draft, so the hashes of the last writes are recorded in the
/// user's state folder.
class LiveExport {
 public:
  LiveExport(std::string path, const std::string& state_folder);
  const std::string& path() const { return path_; }
  /// Why the file may not be written while `draft` is open, and what to do; empty if it may. `draft` may be empty.
  std::string rejected_edit(const std::string& draft) const;
  /// Writes the file. Returns the error, or empty.
  std::string write(std::string_view bytes);

 private:
  std::string path_, record_;
  uint64_t last_ = 0;  // hash of the last write
};

/// The same for --ui-map, which is recognised by its content.
std::string ui_map_refusal(const std::string& path, const std::string& draft);

}  // namespace weftlight::session
