#pragma once
// The programs that show a dialog for files on a Linux desktop, and what they are asked.

#include <string>
#include <vector>

#include "platform/file_question.h"

namespace weftlight::platform {

enum class DialogProgram { kNone, kZenity, kKdialog };
/// The desktop's own program, else the one that is installed. `path` is as $PATH, `desktop` as $XDG_CURRENT_DESKTOP.
DialogProgram find_dialog_program(const std::string& path, const std::string& desktop);
/// The program and its arguments; it prints the chosen path.
std::vector<std::string> dialog_words(DialogProgram program, const FileQuestion& question);

}  // namespace weftlight::platform
