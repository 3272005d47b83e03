#pragma once
// The system's file dialog, by zenity or kdialog as a separate process.

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/names.h"

namespace weftlight::app {

enum class FileAsk { kOpen, kSave, kFolder };

/// Programs that show a file dialog.
enum class Asker { kNone, kZenity, kKdialog };
/// The desktop's own program, else the one that is installed. `path` is as $PATH, `desktop` as $XDG_CURRENT_DESKTOP.
Asker find_asker(const std::string& path, const std::string& desktop);
/// The program and its arguments; it prints the chosen path. `ending` of the file, such as ".wif".
std::vector<std::string> asker_words(Asker asker, FileAsk what, const std::string& title, const std::string& start,
                                     const std::string& ending);

class FileDialog {
 public:
  FileDialog() = default;
  /// Terminates a dialog that is still open, so that quitting does not wait.
  ~FileDialog();
  FileDialog(const FileDialog&) = delete;
  FileDialog& operator=(const FileDialog&) = delete;
  /// False if there is no such program: then ask inside the window.
  static bool is_there();
  /// `ending` of the file, such as ".wif".
  void ask(FileAsk what, const std::string& title, const std::string& start, const std::string& ending,
           std::function<void(const std::string&)> chosen);
  bool waiting() const { return asking_ != 0; }
  /// Calls `chosen` once a path was chosen. Never blocks.
  void poll();

 private:
  pid_t asking_ = 0;  // process of the dialog; 0 if none
  int answer_ = -1;   // its output, non-blocking; -1 after its end
  std::string answer_so_far_;
  std::function<void(const std::string&)> chosen_;
};

}  // namespace weftlight::app
