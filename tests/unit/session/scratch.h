#pragma once
// A folder of its own for each test of files.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "session/names.h"
#include "wif/wif.h"

namespace weftlight::session {

class Scratch : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = ::testing::TempDir() + "weftlight-session-XXXXXX";
    dir_ = mkdtemp(name.data());
  }
  void TearDown() override {
    std::error_code ignored;
    std::filesystem::remove_all(dir_, ignored);
  }
  std::string path(const std::string& name) const { return (dir_ / name).string(); }
  std::string written(const std::string& name, std::string_view bytes) const {
    EXPECT_EQ(write_file_atomically(path(name), bytes), "");
    return path(name);
  }
  std::filesystem::path dir_;
};

}  // namespace weftlight::session
