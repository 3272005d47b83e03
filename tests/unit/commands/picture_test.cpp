// render and reference show one scene: the same threads at the same pixels of the same drape.

#include <cmath>

#include "files/files.h"
#include "scratch_folder.h"

namespace weftlight {
namespace {

using Pictures = ScratchFolder;

/// Root mean square of the difference, over that of the first.
double relative_rms(const Image& a, const Image& b) {
  double difference = 0, square = 0;
  for (size_t i = 0; i < a.texels.size(); ++i) {
    if (i % static_cast<size_t>(a.channels) == 3) continue;
    const double d = static_cast<double>(a.texels[i] - b.texels[i]);
    difference += d * d, square += static_cast<double>(a.texels[i]) * static_cast<double>(a.texels[i]);
  }
  return std::sqrt(difference / square);
}

// A mesh drawn with fewer triangles keeps its shape while the weave slides over it: the error was then 0.5 and more.
TEST_F(Pictures, the_weave_lies_on_a_drape_where_the_traced_threads_lie) {
  const std::string draft = presets_dir() + "/drafts/starter.wif";
  const std::vector<std::string> scene{"--mesh", "tablecloth", "--yarns-per-pixel", "0.3", "--size", "160x120"};
  std::vector<std::string> render{"render", draft, "-o", path("drawn.exr")}, reference{"reference", draft, "-o", path("traced.exr"), "--spp", "64"};
  render.insert(render.end(), scene.begin(), scene.end());
  reference.insert(reference.end(), scene.begin(), scene.end());
  const Ran drawn = run(render);
  if (drawn.code == kNoGraphics) GTEST_SKIP() << drawn.said;
  ASSERT_EQ(drawn.code, kDone) << drawn.said;
  const Ran traced = run(reference);
  ASSERT_EQ(traced.code, kDone) << traced.said;
  const ReadImage a = read_image(path("traced.exr")), b = read_image(path("drawn.exr"));
  ASSERT_TRUE(a.image && b.image) << a.error << b.error;
  ASSERT_EQ(a.image->texels.size(), b.image->texels.size());
  EXPECT_LT(relative_rms(*a.image, *b.image), 0.15);
}

}  // namespace
}  // namespace weftlight
