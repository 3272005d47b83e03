// The finest faces are fitted once for a set and its levels of detail.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "../files/sheet.h"
#include "../scratch.h"
#include "sample_set.h"

namespace weftlight::texture_set {

using base::problem_of;
using drape::sheet;

namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Names of the files that differ or that only the first has.
std::vector<std::string> differing(const fs::path& a, const fs::path& b) {
  std::vector<std::string> out;
  for (const auto& entry : fs::directory_iterator(a)) {
    const fs::path name = entry.path().filename();
    if (bytes_of(a / name) != bytes_of(b / name)) out.push_back(name.string());
  }
  return out;
}

TEST(LevelFits, ASetLeavesItsFitsForItsLevels) {
  const Scratch scratch("level-fits");
  const TextureSetOptions options = options_for(targets::kGltf, 128);
  FinestFits finest;
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", sample_design(), sheet(), options, {}, &finest)), "");
  ASSERT_TRUE(finest.front && finest.back);
  const nlohmann::json set = list_of(scratch / "set");
  EXPECT_EQ(set["fit"]["front"]["rms_error"], finest.front->error);
  EXPECT_EQ(set["fit"]["back"]["rms_error"], finest.back->error);
}

TEST(LevelFits, LevelsHaveTheSameFilesByThemselves) {
  const Scratch scratch("level-fits");
  for (const float distance_m : {1.0f, 0.0f}) {
    TextureSetOptions options = options_for(targets::kGltf, 128);
    options.force = true, options.distance_m = distance_m;
    FinestFits finest;
    for (int lod = 0; lod < kLods; ++lod) {
      const TextureSetOptions level = at_lod(options, lod);
      ASSERT_EQ(problem_of(write_texture_set(scratch / "after", sample_design(), sheet(), level, {}, &finest)), "");
      ASSERT_EQ(problem_of(write_texture_set(scratch / "alone", sample_design(), sheet(), level)), "");
      EXPECT_EQ(differing(scratch / "after", scratch / "alone"), std::vector<std::string>{}) << level.name;
    }
  }
}

TEST(LevelFits, ALevelStaysBesideTheFitsThatItIsGiven) {
  const Scratch scratch("level-fits");
  const TextureSetOptions options = options_for(targets::kGltf, 128);
  FinestFits finest;
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", sample_design(), sheet(), options, {}, &finest)), "");
  const auto highlight = [&](FinestFits* beside) {
    const TextureSetOptions level = at_lod(options, 1);
    EXPECT_EQ(problem_of(write_texture_set(scratch / "level", sample_design(), sheet(), level, {}, beside)), "");
    return list_of(scratch / "level")["fit"]["front"]["highlight"];
  };
  const nlohmann::json own = highlight(nullptr);
  ASSERT_TRUE(finest.front && finest.back);
  finest.front->lobe.fibre *= 1.1f;
  EXPECT_NE(highlight(&finest), own) << "it made the fits of the finest level again";
}

TEST(LevelFits, ASetForgetsTheFitsOfTheOneBefore) {
  const Scratch scratch("level-fits");
  FinestFits finest{EngineFit{}, EngineFit{}};
  const auto done = write_texture_set(scratch / "set", Design{}, sheet(), options_for(targets::kGltf, 32), {}, &finest);
  EXPECT_FALSE(done) << "a draft without cloth";
  EXPECT_FALSE(finest.front || finest.back);
}

}  // namespace
}  // namespace weftlight::texture_set
