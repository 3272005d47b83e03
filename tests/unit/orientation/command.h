#pragma once
// The whole command line.

#include "commands/commands.h"
#include "makers.h"

namespace weftlight::orientation {

using base::problem_of;
using files::Image;

inline void run(std::vector<std::string> args) {
  args.insert(args.begin(), "weftlight");
  std::vector<char*> argv;
  for (std::string& arg : args) argv.push_back(arg.data());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int code = commands::run_command_line(static_cast<int>(argv.size()), argv.data()).exit_code;
  testing::internal::GetCapturedStdout();
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_EQ(code, 0) << said;
}

/// Empty, with a failure, where there is none.
inline Image picture(const std::string& path) {
  base::Result<files::Image> read = files::read_image(path);
  EXPECT_TRUE(read) << path << ": " << problem_of(read);
  return read ? std::move(*read) : Image{};
}

}  // namespace weftlight::orientation
