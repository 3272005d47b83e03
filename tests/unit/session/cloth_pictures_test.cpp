// Lit pictures of several designs at one scale.

#include "session/jobs/cloth_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "weaves/weaves.h"

namespace weftlight::session {

using draft::System;
using weaves::Lean, weaves::twill;

namespace {

TEST(ClothPicturesTest, ShowDesignsAtOneScaleAndEachOnItsThread) {
  const auto fine = std::make_shared<const Design>(twill({2, 2}, Lean::kRight, {16, 16}));
  Design wide = *fine;
  for (float& mm : wide.draft.warp.spacing_mm) mm = 2 * static_cast<float>(spacing_of(*fine, System::kWarp, 0));
  const auto coarse = std::make_shared<const Design>(wide);
  ClothPictures pictures([] {});
  for (const auto& design : {fine, coarse}) pictures.ask(design, 48, 32, 12);
  pictures.wait();
  auto made = pictures.take();
  ASSERT_EQ(made.size(), 2u);
  for (const auto& [design, picture] : made) {
    EXPECT_EQ(picture.width, 48);
    EXPECT_EQ(picture.pixels.size(), size_t{48} * 32);
    EXPECT_GT(*std::ranges::max_element(picture.pixels), *std::ranges::min_element(picture.pixels)) << "threads";
  }
  EXPECT_NE(made[0].second.pixels, made[1].second.pixels) << "its ends are twice as far apart";
  EXPECT_EQ(lit_picture(*fine, 48, 32, 12), made[0].second) << "the same each time";
  EXPECT_TRUE(lit_picture({}, 48, 32, 12).pixels.empty());
}

}  // namespace
}  // namespace weftlight::session
