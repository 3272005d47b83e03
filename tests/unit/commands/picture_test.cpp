// render and reference show one scene: the same threads at the same pixels of the same drape.

#include <filesystem>
#include <optional>

#include "../relative_rms.h"
#include "scratch_folder.h"

namespace weftlight::commands {
namespace {

class Pictures : public ScratchFolder {
 protected:
  /// A shipped draft drawn and traced: how far they are apart. None without graphics.
  std::optional<double> difference(const std::string& draft, const std::vector<std::string>& scene) {
    // As many samples as there are: what differs is not their noise.
    const Ran drawn = picture("render", draft, scene, {"-o", path("drawn.exr"), "--samples", "34"});
    if (drawn.code == kNoGraphics) return std::nullopt;
    EXPECT_EQ(drawn.code, kDone) << drawn.said;
    const Ran traced = picture("reference", draft, scene, {"-o", path("traced.exr"), "--spp", "64"});
    EXPECT_EQ(traced.code, kDone) << traced.said;
    const ReadImage truth = read_image(path("traced.exr")), ours = read_image(path("drawn.exr"));
    if (!truth.image || !ours.image || truth.image->texels.size() != ours.image->texels.size()) {
      ADD_FAILURE() << "not two pictures of one size: " << truth.error << ours.error;
      return 1;
    }
    return relative_rms(*truth.image, *ours.image);
  }

 private:
  static Ran picture(const std::string& verb, const std::string& draft, const std::vector<std::string>& scene,
                     const std::vector<std::string>& options) {
    std::vector<std::string> line{verb, presets_dir() + "/drafts/" + draft + ".wif", "--size", "160x120"};
    line.insert(line.end(), scene.begin(), scene.end());
    line.insert(line.end(), options.begin(), options.end());
    return run(line);
  }
};

// A mesh drawn with fewer triangles keeps its shape while the weave slides over it: 0.40, where all triangles leave
// 0.09.
TEST_F(Pictures, the_weave_lies_on_a_drape_where_the_traced_threads_lie) {
  const std::optional<double> off = difference("starter", {"--mesh", "tablecloth", "--yarns-per-pixel", "0.3"});
  if (!off) GTEST_SKIP() << "no graphics";
  EXPECT_LT(*off, 0.15);
}

// Places under another thread's edge have no horizons of their own. Lit as if they lay on top: 0.33, else 0.22.
TEST_F(Pictures, light_under_the_edges_of_threads_is_the_traced_light) {
  const std::optional<double> off =
      difference("twill_2_2", {"--mesh", "plane", "--view", "-30,20", "--yarns-per-pixel", "0.06"});
  if (!off) GTEST_SKIP() << "no graphics";
  EXPECT_LT(*off, 0.27);
}

// The maps of a dense weave have no gaps, its threads have. Drawn opaque: 0.49, else 0.19.
TEST_F(Pictures, what_is_behind_shows_through_the_pinholes_of_a_near_weave) {
  const std::optional<double> off =
      difference("twill_2_2", {"--mesh", "plane", "--view", "20,15", "--yarns-per-pixel", "0.04"});
  if (!off) GTEST_SKIP() << "no graphics";
  EXPECT_LT(*off, 0.3);
}

TEST_F(Pictures, a_turntable_is_one_turn_in_even_steps) {
  const std::vector<std::string> line{
      "render", presets_dir() + "/drafts/plain.wif", "--mesh", "skirt", "--size", "64x48", "--method", "cloth", "-o"};
  const auto drawn = [&](const std::string& out, const std::vector<std::string>& more) {
    std::vector<std::string> all = line;
    all.push_back(path(out));
    all.insert(all.end(), more.begin(), more.end());
    return run(all).code;
  };
  const int code = drawn("turn.png", {"--turntable", "3", "--view", "100,10"});
  if (code == kNoGraphics) GTEST_SKIP() << "no graphics";
  ASSERT_EQ(code, kDone);
  ASSERT_EQ(drawn("alone.png", {"--view", "-140,10"}), kDone);
  EXPECT_EQ(read_file(path("turn_002.png")).bytes, read_file(path("alone.png")).bytes);
  EXPECT_NE(read_file(path("turn_001.png")).bytes, read_file(path("turn_003.png")).bytes);
  EXPECT_FALSE(std::filesystem::exists(path("turn.png")));
  EXPECT_FALSE(std::filesystem::exists(path("turn_004.png")));
  EXPECT_EQ(drawn("turn.png", {"--turntable", "3", "--stats", path("s.json")}), kUsage);
}

}  // namespace
}  // namespace weftlight::commands
