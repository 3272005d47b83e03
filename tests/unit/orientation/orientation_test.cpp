// Every picture that the program makes of a weave shows the same crossing at the same place.

#include <gtest/gtest.h>

#include "base/whole_files.h"
#include "makers.h"
#include "wif/wif.h"

namespace weftlight::orientation {
namespace {

class Orientation : public testing::TestWithParam<Maker> {
 protected:
  static void SetUpTestSuite() {
    at = std::make_unique<Workplace>();
    ASSERT_EQ(problem_of(base::write_file_atomically(at->draft(), wif::write_new_wif(marked_design()))), "");
  }
  static void TearDownTestSuite() { at.reset(); }
  static inline std::unique_ptr<Workplace> at;
};

TEST_P(Orientation, IsTheSame) {
  std::string skipped;
  const std::vector<Seen> all = GetParam().make(*at, skipped);
  if (!skipped.empty()) GTEST_SKIP() << skipped;
  ASSERT_FALSE(all.empty());
  for (const Seen& s : all) expect_seen(s);
}

constexpr Maker kMakers[] = {
    {"drawdown", drawdowns},
    {"printed_draft", printed_drafts},
    {"printed_swatch", printed_swatches},
    {"thumbnail", thumbnails},
    {"window_drawdown", window_drawdowns},
    {"texture_image", texture_images},
    {"texture_preview", texture_previews},
    {"textured_mesh", textured_meshes},
    {"rendered_cloth", rendered_cloths},
    {"traced_cloth", traced_cloths},
};

INSTANTIATE_TEST_SUITE_P(Pictures, Orientation, testing::ValuesIn(kMakers),
                         [](const testing::TestParamInfo<Maker>& maker) { return std::string(maker.param.name); });

}  // namespace
}  // namespace weftlight::orientation
