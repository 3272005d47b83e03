// The lists of colours and yarns: delete, merge, sort, swap, and gradients.

#include "design/palette_edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "design/edits.h"
#include "design/fibre.h"
#include "design/oklab.h"
#include "design/yarn_presets.h"

namespace weftlight::design {

using draft::blank_draft;

namespace {

constexpr Rgb kBlack{0, 0, 0}, kWhite{1, 1, 1}, kRed{0.8f, 0.1f, 0.1f}, kDarkRed{0.4f, 0, 0}, kBlue{0.1f, 0.2f, 0.8f};

Design colored(std::vector<Rgb> palette, std::vector<int> warp, std::vector<int> weft) {
  Design d;
  d.draft = blank_draft(static_cast<int>(warp.size()), static_cast<int>(weft.size()), 2, 2);
  d.draft.palette = std::move(palette);
  d.draft.warp.color = std::move(warp), d.draft.weft.color = std::move(weft);
  return d;
}

/// The colour of each thread, whatever the order of the palette.
std::vector<Rgb> colors_of(const Design& d, System system) {
  std::vector<Rgb> out;
  for (const int i : d.draft.threads(system).color) out.push_back(d.draft.palette[static_cast<size_t>(i)]);
  return out;
}

void expect_same_cloth(const Design& a, const Design& b) {
  EXPECT_TRUE(is_consistent(b));
  for (const System system : {System::kWarp, System::kWeft}) EXPECT_EQ(colors_of(a, system), colors_of(b, system));
}

TEST(PaletteEdits, ADeletedColourIsReplacedByTheClosest) {
  const Design d = colored({kBlack, kRed, kBlue, kDarkRed}, {0, 1, 2, 3}, {1, 1});
  EXPECT_EQ(closest_color(d, 1), 3);
  EXPECT_EQ(uses_of_colors(d), (std::vector<int>{1, 3, 1, 1}));
  const Design gone = without_color(d, 1, 3);
  EXPECT_EQ(gone.draft.palette, (std::vector<Rgb>{kBlack, kBlue, kDarkRed}));
  EXPECT_EQ(gone.draft.warp.color, (std::vector<int>{0, 2, 1, 2}));
  EXPECT_EQ(gone.draft.weft.color, (std::vector<int>{2, 2}));
  for (const auto& [color, heir] : {std::pair{1, 1}, {9, 0}, {-1, 0}, {0, 9}})
    EXPECT_EQ(without_color(d, color, heir), d);
  EXPECT_EQ(closest_color(colored({kRed}, {0}, {0}), 0), -1);
}

TEST(PaletteEdits, SectionsFollowTheLists) {
  Design d = colored({kBlack, kRed, kBlue}, {0, 0}, {0, 0});
  d.yarns.resize(3);
  ThreadSection section;
  section.threads.resize(2);
  section.threads.color = {2, 1}, section.threads.yarn = {1, 7};  // 7 is read as the first
  d.warp_assembly.sections.push_back(section);
  EXPECT_EQ(without_unused_colors(d).draft.palette.size(), 3u) << "sections use them";
  const Design gone = without_yarn(without_color(d, 1, 0), 0, 2);
  EXPECT_EQ(gone.warp_assembly.sections[0].threads.color, (std::vector<int>{1, 0}));
  EXPECT_EQ(gone.warp_assembly.sections[0].threads.yarn, (std::vector<int>{0, 1}));
  EXPECT_EQ(gone.draft.warp.yarn, (std::vector<int>{1, 1}));
}

TEST(PaletteEdits, EqualColoursAreMergedAsAScreenShowsThem) {
  const Design d = colored({kRed, kBlue, {0.8001f, 0.1f, 0.1f}, kBlue, {0.81f, 0.1f, 0.1f}}, {0, 1, 2, 3, 4}, {3, 2});
  const Design merged = with_merged_colors(d);
  EXPECT_EQ(merged.draft.palette, (std::vector<Rgb>{kRed, kBlue, {0.81f, 0.1f, 0.1f}}));
  EXPECT_EQ(merged.draft.warp.color, (std::vector<int>{0, 1, 0, 1, 2}));
  EXPECT_EQ(merged.draft.weft.color, (std::vector<int>{1, 0}));
  EXPECT_EQ(with_merged_colors(merged), merged);
}

TEST(PaletteEdits, UnusedColoursGoInOneStep) {
  const Design d = colored({kBlack, kRed, kBlue, kWhite}, {3, 1, 1}, {3});
  const Design used = without_unused_colors(d);
  EXPECT_EQ(used.draft.palette, (std::vector<Rgb>{kRed, kWhite}));
  expect_same_cloth(d, used);
}

TEST(PaletteEdits, SortedByHueOrLightnessTheClothStays) {
  const Design d = colored({kBlue, kDarkRed, kBlack, kRed, kWhite}, {0, 1, 2, 3, 4}, {4, 2, 0});
  const Design by_hue = with_sorted_colors(d, ColorOrder::kHue), light = with_sorted_colors(d, ColorOrder::kLightness);
  EXPECT_EQ(by_hue.draft.palette, (std::vector<Rgb>{kWhite, kBlack, kRed, kDarkRed, kBlue})) << "greys, reds, blues";
  EXPECT_EQ(light.draft.palette, (std::vector<Rgb>{kWhite, kRed, kBlue, kDarkRed, kBlack}));
  expect_same_cloth(d, by_hue);
  expect_same_cloth(d, light);
}

TEST(PaletteEdits, ADeletedYarnIsReplacedByOneOfItsFibre) {
  const auto presets = yarn_presets();
  Design d = colored({kBlack}, {0, 0, 0}, {0, 0});
  const Yarn fine = *with_count(presets[0], "Ne 20/2"), coarse = *with_count(presets[0], "Ne 4/2");
  d.yarns = {presets[0], presets[4], coarse, fine};  // cotton, wool
  EXPECT_EQ(closest_yarn(d, 0), 2) << "an octave away; the finer one is more";
  d.draft.warp.yarn = {0, 1, 3};
  d.plan = with_purchase(d.plan, {presets[4].name, 500, 0, 12});
  EXPECT_EQ(uses_of_yarns(d), (std::vector<int>{3, 1, 0, 1}));
  const Design gone = without_yarn(d, 1, 2);
  EXPECT_EQ(gone.yarns, (std::vector<Yarn>{presets[0], coarse, fine}));
  EXPECT_EQ(gone.draft.warp.yarn, (std::vector<int>{0, 1, 2}));
  EXPECT_TRUE(gone.plan.purchases.empty()) << "nobody buys it any more";
  EXPECT_EQ(without_unused_yarns(d).yarns, (std::vector<Yarn>{presets[0], presets[4], fine}));
}

TEST(PaletteEdits, EqualYarnsAreMergedAndSortedByName) {
  Design d = colored({kBlack}, {0, 0, 0}, {0});
  Yarn wool, silk, other_wool;
  wool.name = other_wool.name = "Wool", silk.name = "Silk";
  other_wool.tex = 50;
  d.yarns = {wool, silk, wool, other_wool};
  d.draft.warp.yarn = {2, 3, 1};
  const Design merged = with_merged_yarns(d);
  EXPECT_EQ(merged.yarns, (std::vector<Yarn>{wool, silk, other_wool}));
  EXPECT_EQ(merged.draft.warp.yarn, (std::vector<int>{0, 2, 1}));
  const Design sorted = with_sorted_yarns(merged);
  EXPECT_EQ(sorted.yarns, (std::vector<Yarn>{silk, wool, other_wool}));
  EXPECT_EQ(sorted.draft.warp.yarn, (std::vector<int>{1, 2, 0}));
}

TEST(PaletteEdits, WarpAndWeftExchangeTheirStripes) {
  const Design d = colored({kBlack, kRed, kBlue}, {0, 1, 0, 1, 0}, {2, 2, 2});
  const Design swapped = with_swapped_systems(d);
  EXPECT_EQ(swapped.draft.warp.color, (std::vector<int>{2, 2, 2, 2, 2}));
  EXPECT_EQ(swapped.draft.weft.color, (std::vector<int>{0, 1, 0}));
  EXPECT_EQ(with_swapped_systems(swapped), d) << "stripes of two that go on";
}

TEST(PaletteEdits, LightAndDarkExchangeTheirPlaces) {
  const Design d = colored({kBlack, kBlue, kWhite, kRed}, {0, 2, 0}, {3});
  const Design swapped = with_swapped_lightness(d);
  EXPECT_EQ(swapped.draft.palette, (std::vector<Rgb>{kWhite, kBlue, kBlack, kRed})) << "blue is not used";
  EXPECT_EQ(with_swapped_lightness(swapped), d);
}

TEST(PaletteEdits, LightAndDarkAreExchangedInDyesToo) {
  Design d = colored({kWhite, kRed}, {0, 0, 1, 1}, {0, 0});
  d.yarns[0].dye.stretches = {{4, kBlack, false}, {2, {}, true}, {3, kWhite, false}};
  const Design swapped = with_swapped_lightness(d);
  EXPECT_EQ(swapped.draft.palette, (std::vector<Rgb>{kBlack, kRed}));
  EXPECT_EQ(swapped.yarns[0].dye.stretches,
            (std::vector<DyedStretch>{{4, kWhite, false}, {2, {}, true}, {3, kBlack, false}}));
  EXPECT_EQ(with_swapped_lightness(swapped), d);
}

TEST(PaletteEdits, AGradientIsEvenToTheEye) {
  const std::vector<Rgb> colors = gradient(kBlack, kWhite, 5);
  ASSERT_EQ(colors.size(), 5u);
  EXPECT_EQ(colors.front(), kBlack);
  EXPECT_EQ(colors.back(), kWhite);
  for (size_t i = 0; i + 1 < colors.size(); ++i) EXPECT_NEAR(color_distance(colors[i], colors[i + 1]), 0.25f, 0.005f);
  for (const Rgb color : {kRed, kBlue, kDarkRed}) EXPECT_LT(color_distance(rgb_of(oklab_of(color)), color), 1e-3f);
}

TEST(PaletteEdits, AGradientAcrossThreads) {
  const std::vector<int> all{0, 1, 2, 3, 4, 5, 6, 7};
  const Design d = colored({kBlack, kWhite}, {0, 0, 0, 0, 0, 0, 0, 0}, {1});
  const Design striped = with_gradient(d, System::kWarp, all, {kWhite, kBlack, 4, false});
  EXPECT_EQ(striped.draft.palette.size(), 4u) << "black and white were there";
  EXPECT_EQ(striped.draft.warp.color, (std::vector<int>{1, 1, 2, 2, 3, 3, 0, 0}));
  const Design blended = with_gradient(d, System::kWarp, all, {kBlack, kWhite, 2, true});
  EXPECT_EQ(blended.draft.palette, d.draft.palette) << "two yarns are enough";
  const std::vector<int>& ends = blended.draft.warp.color;
  EXPECT_EQ(std::ranges::count(ends, 1), 4);
  EXPECT_LT(ends[0] + ends[1] + ends[2], ends[5] + ends[6] + ends[7]) << "more and more of the other";
  const Design some = with_gradient(d, System::kWarp, {2, 3, 99}, {kRed, kBlue, 900, false});
  EXPECT_TRUE(is_consistent(some));
  EXPECT_EQ(some.draft.palette.size(), 5u) << "no more colours than threads";
  EXPECT_EQ(some.draft.warp.color[1], 0);
  EXPECT_EQ(with_gradient(d, System::kWarp, {}, {kRed, kBlue, 3, false}), d);
}

}  // namespace
}  // namespace weftlight::design
