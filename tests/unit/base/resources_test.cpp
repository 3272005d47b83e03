// Presets, shaders and languages are found; an environment variable overrides the search.

#include "base/resources.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "platform/environment_variables.h"
#include "platform/folders.h"

namespace weftlight::base {
namespace {

namespace fs = std::filesystem;

TEST(Resources, are_found_from_the_build_folder) {
  EXPECT_TRUE(fs::is_directory(fs::path(presets_dir()) / "drafts"));
  EXPECT_TRUE(fs::exists(fs::path(shaders_dir()) / "cloth.frag"));
}

TEST(Resources, a_variable_overrides_the_search) {
  platform::set_variable("WEFTLIGHT_SHADERS", "/elsewhere");
  EXPECT_EQ(shaders_dir(), "/elsewhere");
  platform::set_variable("WEFTLIGHT_SHADERS", "");
  EXPECT_NE(shaders_dir(), "");
  platform::set_variable("WEFTLIGHT_LANGUAGES", "/elsewhere");
  EXPECT_EQ(languages_dir(), "/elsewhere");
  platform::set_variable("WEFTLIGHT_LANGUAGES", "");
}

TEST(Resources, languages_are_found_beside_the_program) {
  const fs::path languages = fs::path(platform::program_folder()) / "languages";
  const bool there = fs::exists(languages);
  fs::create_directory(languages);
  EXPECT_EQ(fs::path(languages_dir()), languages);
  if (!there) fs::remove(languages);
}

TEST(Resources, the_handbook_is_a_page_or_nothing) {
  const fs::path folder = fs::path(testing::TempDir()) / "handbook";
  fs::create_directories(folder);
  platform::set_variable("WEFTLIGHT_HANDBOOK", folder.string());
  EXPECT_EQ(handbook_page(), "");
  std::ofstream(folder / "index.html") << "page";
  EXPECT_EQ(fs::path(handbook_page()), folder / "index.html");
  platform::set_variable("WEFTLIGHT_HANDBOOK", "");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace weftlight::base
