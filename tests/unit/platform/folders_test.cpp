// The user's folders, by the XDG base directory specification.

#include "platform/folders.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "platform/environment_variables.h"

namespace weftlight::platform {
namespace {

TEST(FoldersTest, a_variable_names_the_folder_and_a_relative_one_is_ignored) {
  const std::string was = variable("XDG_STATE_HOME"), home = variable("HOME");
  set_variable("HOME", "/home/weaver");
  set_variable("XDG_STATE_HOME", "/elsewhere");
  EXPECT_EQ(state_folder(), "/elsewhere");
  for (const char* none : {"", "relative"}) {
    set_variable("XDG_STATE_HOME", none);
    EXPECT_EQ(state_folder(), "/home/weaver/.local/state");
  }
  set_variable("HOME", home);
  set_variable("XDG_STATE_HOME", was);
}

TEST(FoldersTest, the_program_knows_where_it_is) {
  EXPECT_TRUE(std::filesystem::exists(program_folder() + "/platform_test")) << program_folder();
}

}  // namespace
}  // namespace weftlight::platform
