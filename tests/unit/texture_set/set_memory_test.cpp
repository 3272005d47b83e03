// The memory that an export takes does not follow the size of its images.

#include <gtest/gtest.h>

#include <cmath>

#include "../memory_taken.h"
#include "../scratch.h"
#include "sample_set.h"
#include "texture_set/row_cascade.h"
#include "texture_set/targets.h"

namespace weftlight::texture_set {

using files::encode_png;

namespace {

/// Before the first fork: the memory of the library of pictures is not that of a set.
class SetMemory : public testing::Test {
 protected:
  static void SetUpTestSuite() { encode_png({1, 1, 1, {0}}); }
};

/// Of a raw set, in MB; -1 with a failure.
int raw_set_takes(int size) {
  const Scratch scratch("raw-memory");
  const Taken taken = taken_by([&] {
    return problem_of(write_texture_set(scratch / "set", sample_design(), {}, options_for(targets::kRaw, size)));
  });
  EXPECT_EQ(taken.said, "");
  EXPECT_GE(taken.mb, 0);
  return static_cast<int>(taken.mb);
}

// They are 147 and 128 MB. The first was 287 when horizons, maps and texels of both faces were kept; the second 200
// when horizons were kept to the end and copied for the contact sheet, beside a face of 1024 texels.
TEST_F(SetMemory, OfARawSetIsThatOfOneFace) {
  EXPECT_LT(raw_set_takes(1024), 190);
  EXPECT_LT(raw_set_takes(2048), 165);
}

SurfaceTexels patterned(int width, int height) {
  SurfaceTexels out{1, 1, Plane<SurfaceTexel>(width, height)};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      SurfaceTexel& t = out.texels.at(x, y);
      t.coverage = 0.5f + 0.5f * std::sin(0.1f * static_cast<float>(x + 3 * y));
      t.height_mm = std::cos(0.3f * static_cast<float>(x)) * std::sin(0.2f * static_cast<float>(y));
    }
  }
  return out;
}

// Large levels come row by row, small ones as a whole.
TEST(RowCascade, GivesTheLevelsOfTheWholeFace) {
  constexpr int kWidth = 4096, kHeight = 128;
  const SurfaceTexels all = patterned(kWidth, kHeight);
  RowCascade cascade({kWidth, kHeight});
  std::vector<SurfaceTexels> levels;
  std::vector<int> rows;
  const RowCascade::Done done = [&](int level, int y, const SurfaceTexels& part) -> base::Result<void> {
    const auto k = static_cast<size_t>(level) - 1;
    if (levels.size() <= k)
      levels.push_back(blank_like(part, kWidth >> level, std::max(kHeight >> level, 1))), rows.push_back(0);
    EXPECT_EQ(y, rows[k]);
    rows[k] += part.texels.height;
    std::ranges::copy(part.texels.at_, levels[k].texels.row(y));
    return {};
  };
  for (int y = 0; y < kHeight; ++y) {
    SurfaceTexels row = blank_like(all, kWidth, 1);
    std::copy_n(all.texels.row(y), kWidth, row.texels.row(0));
    ASSERT_TRUE(cascade.add(0, std::move(row), done));
  }
  ASSERT_TRUE(cascade.finish(done));
  ASSERT_EQ(levels.size(), 12u);
  SurfaceTexels wanted = all;
  for (size_t k = 0; k < levels.size(); ++k) {
    wanted = half_of(wanted);
    EXPECT_EQ(rows[k], wanted.texels.height);
    for (size_t i = 0; i < wanted.texels.at_.size(); ++i) {
      ASSERT_EQ(levels[k].texels.at_[i].coverage, wanted.texels.at_[i].coverage) << "level " << k + 1;
      ASSERT_EQ(levels[k].texels.at_[i].height_mm, wanted.texels.at_[i].height_mm);
    }
  }
}

}  // namespace
}  // namespace weftlight::texture_set
