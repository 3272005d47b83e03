// Presets, shaders and fonts are found; a variable that is set decides.

#include "base/resources.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/fonts.h"

namespace weftlight::base {
namespace {

namespace fs = std::filesystem;

TEST(Resources, are_found_from_the_build_folder) {
  EXPECT_TRUE(fs::is_directory(fs::path(presets_dir()) / "drafts"));
  EXPECT_TRUE(fs::exists(fs::path(shaders_dir()) / "cloth.frag"));
}

TEST(Resources, a_variable_decides) {
  ASSERT_EQ(::setenv("WEFTLIGHT_SHADERS", "/elsewhere", 1), 0);
  EXPECT_EQ(shaders_dir(), "/elsewhere");
  ASSERT_EQ(::setenv("WEFTLIGHT_SHADERS", "", 1), 0);
  EXPECT_NE(shaders_dir(), "");
  ::unsetenv("WEFTLIGHT_SHADERS");
}

TEST(Fonts, only_of_the_family_that_is_asked_for) {
  const char* const none[] = {"No Such Family 71"};
  EXPECT_EQ(font_file(none), "");
  const char* const some[] = {"No Such Family 71", "Inter", "DejaVu Sans", "Noto Sans"};
  const std::string regular = font_file(some), bold = font_file(some, FontWeight::kSemiBold);
  if (regular.empty()) GTEST_SKIP() << "none of these fonts is installed";
  EXPECT_TRUE(fs::exists(regular)) << regular;
  EXPECT_NE(regular, bold);
}

}  // namespace
}  // namespace weftlight::base
