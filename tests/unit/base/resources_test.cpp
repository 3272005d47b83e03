// Presets, shaders and languages are found; an environment variable overrides the search.

#include "base/resources.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace weftlight::base {
namespace {

namespace fs = std::filesystem;

TEST(Resources, are_found_from_the_build_folder) {
  EXPECT_TRUE(fs::is_directory(fs::path(presets_dir()) / "drafts"));
  EXPECT_TRUE(fs::exists(fs::path(shaders_dir()) / "cloth.frag"));
}

TEST(Resources, a_variable_overrides_the_search) {
  ASSERT_EQ(::setenv("WEFTLIGHT_SHADERS", "/elsewhere", 1), 0);
  EXPECT_EQ(shaders_dir(), "/elsewhere");
  ASSERT_EQ(::setenv("WEFTLIGHT_SHADERS", "", 1), 0);
  EXPECT_NE(shaders_dir(), "");
  ::unsetenv("WEFTLIGHT_SHADERS");
  ASSERT_EQ(::setenv("WEFTLIGHT_LANGUAGES", "/elsewhere", 1), 0);
  EXPECT_EQ(languages_dir(), "/elsewhere");
  ::unsetenv("WEFTLIGHT_LANGUAGES");
}

TEST(Resources, languages_are_found_beside_the_program) {
  const fs::path languages = fs::read_symlink("/proc/self/exe").parent_path() / "languages";
  const bool there = fs::exists(languages);
  fs::create_directory(languages);
  EXPECT_EQ(fs::path(languages_dir()), languages);
  if (!there) fs::remove(languages);
}

TEST(Resources, the_handbook_is_a_page_or_nothing) {
  const fs::path folder = fs::path(testing::TempDir()) / "handbook";
  fs::create_directories(folder);
  ASSERT_EQ(::setenv("WEFTLIGHT_HANDBOOK", folder.c_str(), 1), 0);
  EXPECT_EQ(handbook_page(), "");
  std::ofstream(folder / "index.html") << "page";
  EXPECT_EQ(handbook_page(), folder / "index.html");
  ::unsetenv("WEFTLIGHT_HANDBOOK");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace weftlight::base
