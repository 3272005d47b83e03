#pragma once
// Tests that each have a folder of their own.

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "base/whole_files.h"
#include "scratch.h"

namespace weftlight {

class ScratchTest : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return scratch_ / name; }
  std::string written(const std::string& name, std::string_view bytes) const {
    EXPECT_EQ(problem_of(base::write_file_atomically(path(name), bytes)), "");
    return path(name);
  }

 private:
  const Scratch scratch_;

 protected:
  const std::filesystem::path& dir_ = scratch_.folder;
};

}  // namespace weftlight
