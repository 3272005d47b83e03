// What sets of one design leave for the next ones: levels of detail stay beside the fits of the finest, and other
// targets are fitted to the same light, without making either again.

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

/// The problem of a set of the sample design in a folder.
std::string written(const std::string& folder, const TextureSetOptions& options, SharedWork* shared) {
  return problem_of(write_texture_set(folder, sample_design(), sheet(), options, {}, shared));
}

TEST(SharedWork, ASetLeavesItsFitsForItsLevels) {
  const Scratch scratch("shared-work");
  SharedWork shared;
  ASSERT_EQ(written(scratch / "set", options_for(targets::kGltf, 128), &shared), "");
  const nlohmann::json set = list_of(scratch / "set");
  EXPECT_EQ(shared.finest.target, &targets::kGltf);
  EXPECT_EQ(set["fit"]["front"]["rms_error"], shared.finest.front.error);
  EXPECT_EQ(set["fit"]["back"]["rms_error"], shared.finest.back.error);
}

TEST(SharedWork, SetsHaveTheSameFilesByThemselves) {
  const Scratch scratch("shared-work");
  for (const float distance_m : {1.0f, 0.0f}) {
    SharedWork shared;
    for (const ExportTarget* target : {&targets::kGltf, &targets::kUnityUrp}) {
      TextureSetOptions options = options_for(*target, 128);
      options.force = true, options.distance_m = distance_m;
      for (int lod = 0; lod < kLods; ++lod) {
        const TextureSetOptions level = at_lod(options, lod);
        const std::string name = "-" + std::string(target->id) + std::to_string(lod);
        ASSERT_EQ(written(scratch / ("after" + name), level, &shared), "");
        ASSERT_EQ(written(scratch / ("alone" + name), level, nullptr), "");
        EXPECT_EQ(differing(scratch / ("after" + name), scratch / ("alone" + name)), std::vector<std::string>{})
            << name << " from " << distance_m << " m";
      }
    }
  }
}

TEST(SharedWork, ALevelStaysBesideTheFitsThatItIsGiven) {
  const Scratch scratch("shared-work");
  const TextureSetOptions options = options_for(targets::kGltf, 128);
  SharedWork shared;
  ASSERT_EQ(written(scratch / "set", options, &shared), "");
  const auto highlight = [&](SharedWork* of) {
    EXPECT_EQ(written(scratch / "level", at_lod(options, 1), of), "");
    return list_of(scratch / "level")["fit"]["front"]["highlight"];
  };
  const nlohmann::json own = highlight(nullptr);
  shared.finest.front.lobe.fibre *= 1.1f;
  EXPECT_NE(highlight(&shared), own) << "it made the fits of the finest level again";
}

TEST(SharedWork, ALevelDoesNotStayBesideTheFitsOfAnotherTarget) {
  const Scratch scratch("shared-work");
  SharedWork shared;
  ASSERT_EQ(written(scratch / "gltf", options_for(targets::kGltf, 64), &shared), "");
  // As where the finest set was complete and is left out.
  const TextureSetOptions level = at_lod(options_for(targets::kUnityUrp, 64), 1);
  ASSERT_EQ(written(scratch / "after", level, &shared), "");
  ASSERT_EQ(written(scratch / "alone", level, nullptr), "");
  EXPECT_EQ(differing(scratch / "after", scratch / "alone"), std::vector<std::string>{});
  EXPECT_EQ(shared.finest.target, &targets::kUnityUrp);
}

TEST(SharedWork, TheLightIsMeasuredForTheFirstTargetAlone) {
  const Scratch scratch("shared-work");
  SharedWork shared;
  ASSERT_EQ(written(scratch / "gltf", options_for(targets::kGltf, 64), &shared), "");
  const auto before = shared.light[0];
  ASSERT_TRUE(before[0] && before[1]);
  ASSERT_EQ(written(scratch / "raw", options_for(targets::kRaw, 64), &shared), "");
  ASSERT_EQ(written(scratch / "unity", options_for(targets::kUnityUrp, 64), &shared), "");
  EXPECT_EQ(shared.light[0], before);
}

}  // namespace
}  // namespace weftlight::texture_set
