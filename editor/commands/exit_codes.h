#pragma once
// How the program ends and says why, with a window or without.

#include <string>
#include <vector>

#include "base/result.h"

namespace weftlight::commands {

/// The exit codes of the command-line contract.
enum Exit : int { kDone = 0, kUsage = 2, kBadInput = 3, kNoGraphics = 4, kNotWritten = 5 };

/// What the window is opened with.
struct EditorOptions {
  std::vector<std::string> files;  // each in a tab
  std::string live_export, ui_map;
  bool language_asked = false;  // --language; else that of the settings
  std::string notice;           // what the window says at its start; translated
};

/// Prints "weftlight: problem" on stderr.
void print_problem(const std::string& problem);
/// The exit code of the contract for an error of this kind.
Exit exit_code(base::ErrorKind kind);
/// Prints the error on stderr, as "file:line: what; what to do" or "weftlight: what; what to do"; returns its exit
/// code.
int fail(const base::Error& error);
/// The same for a request that makes no sense.
int refuse(const std::string& problem);
/// kDone, or the same for its error.
int finish(const base::Result<void>& result);

}  // namespace weftlight::commands
