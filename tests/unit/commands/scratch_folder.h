#pragma once
// A temporary folder for a test, and the whole command line run in the process of the test.

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "../scratch_fixture.h"
#include "commands/commands.h"
#include "paths.h"

namespace weftlight::commands {

inline std::string fixture_path(const std::string& name) {
  return std::string(WEFTLIGHT_TESTS_DIR) + "/fixtures/" + name;
}

class ScratchFolder : public ScratchTest {
 protected:
  /// Every file below the folder, by relative path.
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(dir_)) {
      if (!entry.is_directory()) names.insert(entry.path().lexically_relative(dir_).string());
    }
    return names;
  }
};

/// The exit code of `weftlight ARGS`; said: stderr, out: stdout; opened: the files for the editor, whose code is -1.
struct Ran {
  int code = -1;
  std::string said, out;
  std::vector<std::string> opened;
};
inline Ran run(std::vector<std::string> args) {
  args.insert(args.begin(), "weftlight");
  std::vector<char*> argv;
  for (std::string& arg : args) argv.push_back(arg.data());
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  const CommandLine line = run_command_line(static_cast<int>(argv.size()), argv.data());
  std::string out = ::testing::internal::GetCapturedStdout();
  std::string said = ::testing::internal::GetCapturedStderr();
  return {line.open_editor ? -1 : line.exit_code, said, out, line.editor.files};
}

}  // namespace weftlight::commands
