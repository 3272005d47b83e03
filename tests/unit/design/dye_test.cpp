#include "design/dye.h"

#include <gtest/gtest.h>

#include <set>

#include "../hand_drafts.h"
#include "design/oklab.h"
#include "design/repeat.h"
#include "draft/hex_color.h"

namespace weftlight::design {

using draft::drawdown, draft::hex_of, draft::rgb_from_hex;

namespace {

const Rgb kRed{1, 0, 0}, kBlue{0, 0, 1}, kOwn{0.2f, 0.4f, 0.6f};

Dye red_then_blue(int red, int blue) { return {{{red, kRed, false}, {blue, kBlue, false}}, 0, 0}; }

/// A 2/2 twill whose warp is of a dyed yarn.
Design with_dyed_warp(int ends, int picks, Dye dye) {
  Design d = straight_twill(ends, picks);
  Yarn yarn;
  yarn.dye = std::move(dye);
  d.yarns.push_back(yarn);
  d.draft.warp.yarn.assign(static_cast<size_t>(ends), 1);
  return d;
}

TEST(Dye, HasAColourForEachThreadThatIsCrossed) {
  EXPECT_EQ(dye_colors(red_then_blue(2, 1), kOwn), (std::vector<Rgb>{kRed, kRed, kBlue}));
  Dye own = red_then_blue(1, 2);
  own.stretches[0].color.reset();
  EXPECT_EQ(dye_colors(own, kOwn), (std::vector<Rgb>{kOwn, kBlue, kBlue}));
  EXPECT_EQ(length_of(own), 3);
  EXPECT_EQ(length_of(Dye{}), 0);
  EXPECT_TRUE(dye_colors({}, kOwn).empty());
}

TEST(Dye, FadesEvenlyIntoTheNextStretchAndTheLastIntoTheFirst) {
  Dye dye{{{4, Rgb{0, 0, 0}, true}, {2, Rgb{1, 1, 1}, true}}, 0, 0};
  const std::vector<Rgb> colors = dye_colors(dye, kOwn);
  ASSERT_EQ(colors.size(), 6u);
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(oklab_of(colors[static_cast<size_t>(i)]).lightness, (static_cast<float>(i) + 0.5f) / 4, 1e-3f);
  EXPECT_NEAR(oklab_of(colors[4]).lightness, 0.75f, 1e-3f);
  EXPECT_NEAR(oklab_of(colors[5]).lightness, 0.25f, 1e-3f);
}

TEST(Dye, ShiftsFromThreadToThreadAndScattersWithinItsLimit) {
  Dye dye = red_then_blue(5, 5);
  dye.shift = 3;
  EXPECT_EQ(dye_phase(dye, System::kWarp, 0), 0);
  EXPECT_EQ(dye_phase(dye, System::kWarp, 2), 6);
  EXPECT_EQ(dye_phase(dye, System::kWarp, 4), 2) << "in a sequence of ten";
  dye.shift = -3;
  EXPECT_EQ(dye_phase(dye, System::kWarp, 2), 4);
  dye.shift = 0, dye.scatter = 2;
  std::set<int> phases;
  for (int i = 0; i < 200; ++i) {
    const int phase = dye_phase(dye, System::kWeft, i);
    EXPECT_EQ(phase, dye_phase(dye, System::kWeft, i));
    phases.insert(phase);
  }
  EXPECT_EQ(phases, (std::set<int>{0, 1, 2, 8, 9}));
}

TEST(Dye, IsReadAsItIsWritten) {
  const std::vector<DyedStretch> stretches{
      {12, *rgb_from_hex("#1F3B73"), false}, {6, *rgb_from_hex("#E8E0D0"), true}, {20, {}, false}};
  EXPECT_EQ(dye_text(stretches), "12 #1F3B73, 6 #E8E0D0 fades, 20 own");
  EXPECT_EQ(dye_from_text(dye_text(stretches)), stretches);
  EXPECT_EQ(dye_from_text(" 12  #1f3b73 ,6 #E8e0d0 FADES,\t20 Own "), stretches);
  EXPECT_EQ(dye_from_text(""), std::vector<DyedStretch>{});
}

TEST(Dye, IsRefusedWhereTheTextIsNotOne) {
  for (const char* bad : {"12", "#1F3B73", "0 own", "-3 own", "10001 own", "12 own,", ", 12 own", "12 own fade",
                          "12 own fades fades", "12.5 own", "12 #1F3B7", "12 #1F3B7G", "12 blue", "99999999999 own"})
    EXPECT_FALSE(dye_from_text(bad)) << bad;
  std::string many = "1 own";
  for (size_t i = 1; i < kMaxDyedStretches; ++i) many += ", 1 own";
  EXPECT_TRUE(dye_from_text(many));
  EXPECT_FALSE(dye_from_text(many + ", 1 own"));
}

TEST(DyedThreads, KnowTheColourAtEachCrossing) {
  Design d = with_dyed_warp(8, 8, red_then_blue(2, 1));
  d.yarns[1].dye.shift = 1;
  const DyedThreads dyed(d);
  ASSERT_FALSE(dyed.empty());
  EXPECT_EQ(dyed.color(System::kWeft, 0, 0), nullptr) << "the weft is of another yarn";
  EXPECT_EQ(*dyed.color(System::kWarp, 0, 0), kRed);
  EXPECT_EQ(*dyed.color(System::kWarp, 0, 2), kBlue);
  EXPECT_EQ(*dyed.color(System::kWarp, 0, 3), kRed) << "it repeats";
  EXPECT_EQ(*dyed.color(System::kWarp, 1, 1), kBlue) << "starts a thread earlier";
  EXPECT_TRUE(DyedThreads(straight_twill(4, 4)).empty());
  d.draft.warp.yarn.assign(8, 0);
  EXPECT_TRUE(DyedThreads(d).empty()) << "no thread is of that yarn";
}

TEST(DyedThreads, RepeatWithTheWeaveWhereTheirLengthAllows) {
  const auto repeat = [](const Design& d) {
    const Repeat r = design_repeat(d, drawdown(d.draft));
    return std::pair{r.ends, r.picks};
  };
  EXPECT_EQ(repeat(with_dyed_warp(24, 24, {})), (std::pair{4, 4}));
  EXPECT_EQ(repeat(with_dyed_warp(24, 24, red_then_blue(4, 2))), (std::pair{4, 12}));
  EXPECT_EQ(repeat(with_dyed_warp(24, 24, red_then_blue(4, 3))), (std::pair{4, 24})) << "seven do not fit";
  Dye shifted = red_then_blue(4, 4);
  shifted.shift = 1;
  EXPECT_EQ(repeat(with_dyed_warp(24, 24, shifted)), (std::pair{8, 8}));
}

}  // namespace
}  // namespace weftlight::design
