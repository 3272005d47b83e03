#pragma once
// The system's file dialog, through zenity or kdialog, which runs beside the window.

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/names.h"

namespace weftlight::app {

enum class FileAsk { kOpen, kSave, kFolder };

/// Programs that ask for a file.
enum class Asker { kNone, kZenity, kKdialog };
/// The one of the desktop, else the one that is there. `path`: folders as in $PATH; `desktop`: as $XDG_CURRENT_DESKTOP.
Asker find_asker(const std::string& path, const std::string& desktop);
/// The program and its arguments; it prints the chosen path. `ending`: of what is saved or opened, ".wif".
std::vector<std::string> asker_words(Asker asker, FileAsk what, const std::string& title, const std::string& start,
                                     const std::string& ending);

class FileDialog {
 public:
  FileDialog() = default;
  /// Ends the program that is still asking: who quits does not wait for an answer.
  ~FileDialog();
  FileDialog(const FileDialog&) = delete;
  FileDialog& operator=(const FileDialog&) = delete;
  /// False without a program that asks: ask inside the window instead.
  static bool is_there();
  /// `ending`: of what is saved, ".wif".
  void ask(FileAsk what, const std::string& title, const std::string& start, const std::string& ending,
           std::function<void(const std::string&)> chosen);
  bool waiting() const { return asking_ != 0; }
  /// Calls `chosen` once an answer has come. Never waits.
  void poll();

 private:
  pid_t asking_ = 0;  // the program, 0: none
  int answer_ = -1;   // what it prints, read without waiting; -1: all is read
  std::string answer_so_far_;
  std::function<void(const std::string&)> chosen_;
};

}  // namespace weftlight::app
