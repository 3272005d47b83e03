// Any design, into any file, and back.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "draft/drawdown.h"
#include "lines.h"

namespace weftlight::wif {

using design::Assembly, design::ClothPlan, design::Design, design::Leading, design::Method, design::NamedView,
    design::ThreadSection, design::Twist, design::Yarn, design::is_consistent, design::with_purchase;
using draft::BitMatrix, draft::Draft, draft::Rgb, draft::ShedControl, draft::Threads, draft::drawdown, draft::kFromYarn;

namespace {

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  int upto(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n + 1)); }
  bool coin() { return upto(1) == 1; }
  float between(float low, float high) { return low + (high - low) * static_cast<float>(upto(1 << 24)) / (1 << 24); }
  template <class T, size_t N>
  T one_of(const T (&all)[N]) {
    return all[upto(N - 1)];
  }

 private:
  std::mt19937 random_;
};

BitMatrix random_bits(Dice& dice, int rows, int cols) {
  BitMatrix bits(rows, cols);
  const int share = dice.upto(3);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) bits.set(r, c, dice.upto(3) < share);
  }
  return bits;
}

Threads random_threads(Dice& dice, int count, int colors, int yarns) {
  Threads threads;
  threads.resize(count);
  const bool plain = dice.coin();
  for (size_t i = 0; i < static_cast<size_t>(count); ++i) {
    threads.color[i] = dice.upto(colors - 1);
    threads.yarn[i] = dice.upto(yarns - 1);
    const float measures[] = {kFromYarn, kFromYarn, 0, 1e-7f, 2.12f, 1e31f, dice.between(0, 3)};
    threads.spacing_mm[i] = plain ? kFromYarn : dice.one_of(measures);
    threads.thickness_mm[i] = plain ? 1.5f : dice.one_of(measures);
  }
  return threads;
}

std::string random_text(Dice& dice) {
  static const char* const kTexts[] = {"",           "Plain",       " edges ",
                                       "two\nlines", "back\\slash", "; no comment",
                                       "Köper",      "織物",        "[x]",
                                       "a=b",        "tab\there",   "true",
                                       "Ã©",         "1,2 ; 3",     "\xE2\x80\x9Cquoted\xE2\x80\x9D"};
  return dice.one_of(kTexts);
}

Yarn random_yarn(Dice& dice) {
  Yarn yarn;
  yarn.name = random_text(dice);
  yarn.diameter_mm = dice.between(0, 50);
  if (dice.coin()) yarn.tex = dice.between(0.1f, 2000);
  yarn.twist = static_cast<Twist>(dice.upto(2));
  yarn.plies = 1 + dice.upto(7);
  yarn.turns_per_m = dice.between(0, 5000);
  yarn.lobes.fuzz_width = dice.between(0.05f, 1);
  yarn.lobes.specular_tint = {dice.between(0, 1), 0.5f, 1};
  yarn.lobes.metallic = dice.coin();
  return yarn;
}

ClothPlan random_plan(Dice& dice) {
  ClothPlan plan;
  plan.width_mm = dice.between(0, 2000);
  plan.warp_shrinkage = dice.between(0, 0.5f);
  plan.ends_per_cm = dice.coin() ? dice.between(1, 40) : 0;
  plan.pieces = 1 + dice.upto(5);
  plan.reed = {static_cast<float>(dice.upto(60)), dice.coin()};
  for (int dents = dice.upto(4); dents > 0; --dents) plan.sleying.push_back(dice.upto(3));
  plan.floating_selvedges = dice.coin();
  for (int yarns = dice.upto(3); yarns > 0; --yarns)
    plan = with_purchase(plan, {random_text(dice), dice.between(0, 500), dice.between(0, 9000), dice.between(1, 99)});
  return plan;
}

Design random_design(unsigned seed) {
  Dice dice(seed);
  Design design;
  Draft& draft = design.draft;
  draft.shafts = 1 + dice.upto(8);
  draft.treadles = 1 + dice.upto(8);
  const int ends = 1 + dice.upto(11), picks = 1 + dice.upto(11), colors = 1 + dice.upto(4);
  if (dice.coin()) {
    design.yarns = {random_yarn(dice), random_yarn(dice)};
  }
  for (int i = 0; i < colors; ++i) {
    draft.palette.push_back(dice.coin() ? Rgb{0, 1, static_cast<float>(51.0 / 255)}
                                        : Rgb{dice.between(-1, 2), dice.between(0, 1), 0.5f});
  }
  draft.rising = dice.coin();
  draft.shed_control = dice.coin() ? ShedControl::kTreadling : ShedControl::kLiftplan;
  draft.threading = random_bits(dice, ends, draft.shafts);
  draft.tieup = random_bits(dice, draft.treadles, draft.shafts);
  draft.treadling = random_bits(dice, picks, draft.treadles);
  draft.liftplan = random_bits(dice, picks, draft.shafts);
  draft.warp = random_threads(dice, ends, colors, static_cast<int>(design.yarns.size()));
  draft.weft = random_threads(dice, picks, colors, static_cast<int>(design.yarns.size()));
  design.title = random_text(dice);
  design.author = random_text(dice);
  for (int i = dice.upto(4); i > 0; --i) design.notes.push_back(random_text(dice));
  if (dice.coin()) design.look = {static_cast<Method>(dice.upto(8)), dice.between(0, 1), dice.between(-4, 4)};
  if (dice.coin()) {
    design.scene.mesh = random_text(dice);
    design.scene.pan_x = dice.between(-1, 1);
    design.scene.background = {0.1f, 0.2f, dice.between(0, 1)};
  }
  if (dice.coin()) {
    if (dice.coin())
      design.finish = {dice.between(0, 1), dice.between(0, 1), dice.between(0, 1),
                       dice.coin() ? 1 : dice.between(0, 1)};
    design.loom = {static_cast<Leading>(dice.upto(2)),
                   dice.coin(),
                   dice.upto(8),
                   dice.upto(8),
                   dice.upto(99),
                   dice.upto(99),
                   dice.upto(99),
                   dice.coin(),
                   dice.coin(),
                   dice.coin()};
    for (int i = dice.upto(2); i > 0; --i)
      design.weaves.push_back({"twill", {{"lean", random_text(dice)}, {"ratio", "2/2"}}, dice.upto(9), 4, 0, 7});
  }
  if (dice.coin()) design.plan = random_plan(dice);
  for (Assembly* assembly : {&design.warp_assembly, &design.weft_assembly}) {
    for (int i = dice.upto(2); i > 0; --i) {
      ThreadSection& section = assembly->sections.emplace_back();
      section.name = std::string(1, static_cast<char>('A' + i));
      const int threads = dice.upto(3);
      section.rows = random_bits(dice, threads, 1 + dice.upto(5));
      section.threads = random_threads(dice, threads, 3, 2);
      section.shed_control = dice.coin() ? ShedControl::kTreadling : ShedControl::kLiftplan;
    }
    if (dice.coin()) assembly->order = random_text(dice) + "A 3x, (B)";
  }
  for (int i = dice.upto(3); i > 1; --i) {
    NamedView& view = design.views.emplace_back();
    view.name = random_text(dice) + std::to_string(i);
    view.flat = dice.coin();
    if (dice.coin()) view.scene.mesh = random_text(dice), view.scene.light_azimuth = dice.between(-90, 90);
  }
  return design;
}

TEST(round_trip, a_new_file_holds_any_design) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Design design = random_design(seed);
    ASSERT_TRUE(is_consistent(design)) << "seed " << seed;
    EXPECT_TRUE(opened(write_new_wif(design)).design == design) << "seed " << seed << "\n" << write_new_wif(design);
  }
}

TEST(round_trip, any_file_can_become_any_design) {
  for (const std::string& name : fixture_names()) {
    const WifFile file = opened(fixture(name));
    for (unsigned seed = 0; seed < 60; ++seed) {
      const Design design = random_design(seed);
      const std::string bytes = write_wif(file, design);
      EXPECT_TRUE(opened(bytes).design == design) << name << " seed " << seed << "\n" << bytes;
      if (::testing::Test::HasFailure()) return;
    }
  }
}

TEST(round_trip, undo_across_a_save_gives_the_first_design_back) {
  for (const std::string& name : fixture_names()) {
    const WifFile file = opened(fixture(name));
    const WifFile other = opened(write_wif(file, random_design(7)));
    EXPECT_TRUE(opened(write_wif(other, file.design)).design == file.design) << name;
  }
}

TEST(plain, keeps_the_cloth_and_is_plain) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Design design = random_design(seed);
    for (const PlainShedControl shed_control :
         {PlainShedControl::kAsIs, PlainShedControl::kLiftplan, PlainShedControl::kTreadling}) {
      const std::string bytes = write_plain_wif(design, shed_control);
      const WifFile file = opened(bytes);
      EXPECT_TRUE(drawdown(file.design.draft) == drawdown(design.draft)) << "seed " << seed;
      EXPECT_EQ(bytes.find("PRIVATE"), std::string::npos);
      EXPECT_NE(bytes.find("[TIEUP]"), std::string::npos) << "seed " << seed;
      EXPECT_NE(bytes.find("[LIFTPLAN]"), std::string::npos) << "seed " << seed;
      EXPECT_TRUE(std::all_of(bytes.begin(), bytes.end(),
                              [](char c) { return c == '\r' || c == '\n' || (c >= ' ' && c < 127); }));
      if (shed_control == PlainShedControl::kLiftplan) {
        EXPECT_EQ(file.design.draft.shed_control, ShedControl::kLiftplan);
      }
    }
  }
}

TEST(plain, head_order_and_notes) {
  Design design = opened(fixture("utf8_bom.wif")).design;
  design.notes = {"A note that is longer than the console of a loom can show at once\nand a second line"};
  const std::string bytes = write_plain_wif(design);
  EXPECT_EQ(bytes.find("[WIF]\r\nVersion=1.1\r\nDate=April 20, 1997\r\nDevelopers=wif@mhsoft.com\r\n"), 0u);
  size_t last = 0;
  for (const char* section : {"[WIF]", "[CONTENTS]", "[COLOR PALETTE]", "[TEXT]", "[WEAVING]", "[WARP]", "[WEFT]",
                              "[COLOR TABLE]", "[THREADING]", "[TIEUP]", "[TREADLING]", "[LIFTPLAN]"}) {
    const size_t at = bytes.find(section);
    ASSERT_NE(at, std::string::npos) << section;
    EXPECT_GE(at, last) << section;
    last = at;
  }
  EXPECT_NE(bytes.find("Title=Korper fur Armel\r\n"), std::string::npos);
  for (const std::string& note : opened(bytes).design.notes) EXPECT_LE(note.size(), 32u) << note;
}

}  // namespace
}  // namespace weftlight::wif
