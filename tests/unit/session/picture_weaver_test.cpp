// A picture as a draft, with the choices of its dialog.

#include "session/jobs/picture_weaver.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../scratch_fixture.h"
#include "draft/drawdown.h"
#include "weaves/families.h"
#include "weaves/weaves.h"

namespace weftlight::session {

using draft::BitMatrix, draft::drawdown;
using files::Image, files::PixelType, files::write_image;
using weaves::Lean, weaves::read_weave_words, weaves::twill;

namespace {

/// Left third black, then grey, then white; its last column is red.
Image stripes(int width, int height) {
  Image out{width, height, 3, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float grey = x * 3 < width ? 0.0f : x * 3 < 2 * width ? 0.5f : 1.0f;
      const bool red = x == width - 1;
      for (const float channel : {red ? 1.0f : grey, red ? 0.0f : grey, red ? 0.0f : grey})
        out.texels.push_back(channel);
    }
  return out;
}

PictureChoices three_colors() {
  PictureChoices choices;
  choices.draft.colors = 3;
  choices.draft.crop = {0, 0, 48, 24};
  return choices;
}

TEST(PictureResults, KeepWhatIsNotTheWeave) {
  Design base = twill({2, 2}, Lean::kRight, {8, 8});
  base.title = "Scarf", base.scene.mesh = "skirt", base.loom.shafts = 4;
  const auto made = picture_result(base, stripes(49, 24), three_colors(), 100, 100);
  ASSERT_TRUE(made) << problem_of(made);
  EXPECT_EQ(made->design->title, "Scarf");
  EXPECT_EQ(made->design->scene.mesh, "skirt");
  EXPECT_EQ(made->design->loom.shafts, 0) << "the limits were of another loom";
  EXPECT_EQ(made->design->draft.ends(), 48) << "the red column is cut off";
  EXPECT_EQ(made->design->draft.picks(), 24);
  EXPECT_EQ(made->colors.size(), 3u);
  EXPECT_NEAR(made->portion[0], 1.0f / 3, 0.03f);
  EXPECT_LE(made->floats.warp_front, 7);
  EXPECT_EQ(made->shown.width, 96) << "each end once, two pixels wide";
  EXPECT_EQ(made->shown.height, 48);
  EXPECT_TRUE(is_consistent(*made->design));
}

TEST(PictureResults, WeaveEachColourAsChosen) {
  PictureChoices choices = three_colors();
  choices.draft.weaves = {*read_weave_words("plain"), BitMatrix(), *read_weave_words("twill 1/3")};
  const auto made = picture_result({}, stripes(49, 24), choices, 100, 100);
  ASSERT_TRUE(made);
  const BitMatrix cells = drawdown(made->design->draft);
  // End 1 is at the right of the picture: ends 17 from the right are white, those from 33 black.
  EXPECT_EQ(cells.get(8, 40), !cells.get(8, 41)) << "plain weave in the black";
  EXPECT_EQ(cells.get(8, 40), !cells.get(9, 40));
  int up = 0;
  for (int end = 4; end < 12; ++end) up += cells.get(8, end) ? 1 : 0;
  EXPECT_EQ(up, 2) << "one end of four in the white";
}

TEST(PictureResults, HaveTheSizeColoursAndLoomThatWereChosen) {
  PictureChoices choices = three_colors();
  choices.draft.ends = 24, choices.draft.picks = 36, choices.draft.own_colors = true;
  choices.jacquard = false, choices.loom = {8, 10};
  const auto made = picture_result({}, stripes(49, 24), choices, 100, 100);
  ASSERT_TRUE(made);
  const draft::Draft& draft = made->design->draft;
  EXPECT_EQ(draft.ends(), 24);
  EXPECT_EQ(draft.picks(), 36);
  EXPECT_LE(draft.shafts, 8);
  EXPECT_EQ(made->design->loom.shafts, 8);
  EXPECT_GE(made->wrong, 0);
  EXPECT_LT(draft.palette[0].r, 0.1f);
  EXPECT_GT(draft.palette[1].r, 0.9f);
}

TEST(PictureResults, ThatCannotBeMadeSayWhy) {
  PictureChoices choices;
  choices.draft.crop = {40, 0, 20, 10};
  EXPECT_NE(problem_of(picture_result({}, stripes(49, 24), choices, 10, 10)).find("beyond"), std::string::npos);
  EXPECT_FALSE(picture_result({}, Image{}, {}, 10, 10));
  choices.draft.crop = {}, choices.draft.ends = 5000;
  EXPECT_FALSE(picture_result({}, stripes(49, 24), choices, 10, 10));
}

class PictureWeavers : public ScratchTest {};

TEST_F(PictureWeavers, ReadThePictureAndWeaveTheLastChoices) {
  ASSERT_TRUE(write_image(path("stripes.png"), stripes(49, 24), PixelType::kU8));
  PictureWeaver weaver(path("stripes.png"), std::make_shared<const Design>(), 64, 64, [] {});
  weaver.wait();
  ASSERT_TRUE(weaver.poll());
  EXPECT_EQ(weaver.size().width, 49);
  EXPECT_EQ(weaver.source().width, 64);
  PictureChoices choices = three_colors();
  weaver.ask(choices);
  choices.draft.ends = 20;
  weaver.ask(choices);
  weaver.wait();
  weaver.poll();
  ASSERT_TRUE(weaver.is_current()) << weaver.problem();
  EXPECT_EQ(weaver.result()->design->draft.ends(), 20);
  choices.draft.ends = 5000;
  weaver.ask(choices);
  weaver.wait();
  weaver.poll();
  EXPECT_NE(weaver.problem(), "");
  EXPECT_FALSE(weaver.is_current());
}

TEST_F(PictureWeavers, SayWhatCannotBeRead) {
  PictureWeaver weaver(path("none.png"), std::make_shared<const Design>(), 64, 64, [] {});
  weaver.wait();
  weaver.poll();
  EXPECT_NE(weaver.problem(), "");
}

}  // namespace
}  // namespace weftlight::session
