#pragma once
// The user's desktop: its file manager, its browser and its own dialog for files.

#include <functional>
#include <memory>
#include <string>
#include <tl/expected.hpp>

#include "platform/file_question.h"

namespace weftlight::platform {

struct MissingProgram {
  std::string program;  // its name
};
/// Shows a folder in the file manager, without waiting for it.
tl::expected<void, MissingProgram> show_folder(const std::string& folder);
/// Shows a page, an .html file, in the browser, without waiting for it.
tl::expected<void, MissingProgram> show_page(const std::string& file);

/// The desktop's own dialog for a file or a folder. It asks before it gives an existing file to save to.
class FileDialog {
 public:
  FileDialog();
  /// Closes a dialog that is still open, so that quitting does not wait.
  ~FileDialog();
  FileDialog(const FileDialog&) = delete;
  FileDialog& operator=(const FileDialog&) = delete;

  /// False if there is no such dialog: then ask inside the window.
  static bool is_there();
  /// Opens the dialog, unless one is open already.
  void ask(const FileQuestion& question, std::function<void(const std::string& path)> chosen);
  bool waiting() const { return asked_ != nullptr; }
  /// Calls `chosen` once a path is chosen. Never waits.
  void poll();

 private:
  struct Asked;  // the open dialog
  std::unique_ptr<Asked> asked_;
  std::function<void(const std::string&)> chosen_;
};

}  // namespace weftlight::platform
