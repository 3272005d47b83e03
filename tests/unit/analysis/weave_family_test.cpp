#include "analysis/weave_family.h"

#include <gtest/gtest.h>

#include <string>

namespace weftlight::analysis {
namespace {

/// Picks of ends, "#" where the warp is on top.
std::string family(const std::vector<std::string>& picks) {
  BitMatrix cells(static_cast<int>(picks.size()), static_cast<int>(picks[0].size()));
  for (int p = 0; p < cells.rows(); ++p)
    for (int e = 0; e < cells.cols(); ++e)
      if (picks[static_cast<size_t>(p)][static_cast<size_t>(e)] == '#') cells.set(p, e, true);
  return kWeaveFamilyNames[static_cast<size_t>(weave_family(cells))].id;
}

TEST(WeaveFamily, PlainAndItsRelations) {
  EXPECT_EQ(family({"#.", ".#"}), "plain");
  EXPECT_EQ(family({"#.#.", ".#.#", "#.#.", ".#.#"}), "plain");
  EXPECT_EQ(family({"##..", "##..", "..##", "..##"}), "basket");
  EXPECT_EQ(family({"##..", "..##"}), "basket") << "a weft rib";
}

TEST(WeaveFamily, Twills) {
  EXPECT_EQ(family({"#..", ".#.", "..#"}), "twill");
  EXPECT_EQ(family({"##..", ".##.", "..##", "#..#"}), "twill");
  EXPECT_EQ(family({"#...", "..#.", ".#..", "...#"}), "twill") << "broken";
  EXPECT_EQ(family({"##..##", ".##..#", "..##..", "#..##."}), "twill") << "the drawdown ends within a repeat";
}

TEST(WeaveFamily, Satins) {
  EXPECT_EQ(family({"#....", "..#..", "....#", ".#...", "...#."}), "satin");
  EXPECT_EQ(family({".####", "##.##", "####.", "#.###", "###.#"}), "satin") << "warp-faced";
  EXPECT_EQ(family({"#....", ".#...", "..#..", "...#.", "....#"}), "twill") << "a twill of five, one up";
}

TEST(WeaveFamily, Corkscrew) {
  EXPECT_EQ(family({"##.#.#.#.", "#.##.#.#.", "#.#.##.#.", "#.#.#.##.", "#.#.#.#.#", ".##.#.#.#", ".#.##.#.#",
                    ".#.#.##.#", ".#.#.#.##"}),
            "twill");
}

TEST(WeaveFamily, WaffleAndHoneycomb) {
  EXPECT_EQ(family({"#.#####.", ".#.###.#", "..#.#.#.", "...#.#..", "....#...", "...#.#..", "..#.#.#.", ".#.###.#"}),
            "cells")
      << "on five shafts";
  // Two picks of plain weave, then a block of floats beside a block of plain weave; then the blocks change places.
  std::vector<std::string> honeycomb;
  for (int p = 0; p < 20; ++p) {
    honeycomb.emplace_back();
    for (int e = 0; e < 16; ++e) {
      const bool outline = p % 10 < 2, floats = !outline && (e < 8) == (p < 10);
      honeycomb.back() += floats || (p + e) % 2 == 0 ? '#' : '.';
    }
  }
  EXPECT_EQ(family(honeycomb), "cells");
}

TEST(WeaveFamily, ClothsInLayers) { EXPECT_EQ(family({"#...", "###.", "..#.", "#.##"}), "double"); }

TEST(WeaveFamily, TwoWarpsThatFollowOneLine) {
  // Echo weave: the line goes to and fro over the shafts of a 4/4 twill, the second warp four shafts above the first.
  std::vector<std::string> echo(8);
  for (int p = 0; p < 8; ++p)
    for (const int shaft : {0, 1, 2, 3, 4, 5, 4, 3, 2, 1})
      for (const int above : {0, 3}) echo[static_cast<size_t>(p)] += (shaft + above + p) % 8 < 4 ? '#' : '.';
  EXPECT_EQ(family(echo), "parallel");
  for (std::string& pick : echo)
    for (char& cell : pick) cell = cell == '#' ? '.' : '#';
  EXPECT_EQ(family(echo), "parallel") << "the back";
}

TEST(WeaveFamily, TwoWeftsThatChangeFaces) {
  // Taquete: of each pair of picks one is on the face, in blocks; every other end binds both.
  std::vector<std::string> taquete;
  for (int p = 0; p < 8; ++p) {
    taquete.emplace_back();
    for (int e = 0; e < 16; ++e) {
      const bool binds = e % 2 == 0, raised = binds ? (p / 2 + e / 2) % 2 == 0 : (e < 8) == (p % 2 == 0);
      taquete.back() += raised ? '#' : '.';
    }
  }
  EXPECT_EQ(family(taquete), "pattern");
}

TEST(WeaveFamily, StitchedClothsAreDouble) {
  // Two 2/2 twills, one over the other; a lower end rises over an upper pick once in a repeat.
  std::vector<std::string> stitched;
  for (int p = 0; p < 8; ++p) {
    stitched.emplace_back();
    for (int e = 0; e < 8; ++e) {
      const bool upper_end = e % 2 == 0, upper_pick = p % 2 == 0;
      const bool own = (p / 2 + e / 2) % 4 < 2, stitch = p == 2 && e == 1;
      stitched.back() += (upper_end == upper_pick ? own : upper_end) || stitch ? '#' : '.';
    }
  }
  EXPECT_EQ(family(stitched), "double");
}

TEST(WeaveFamily, WhatIsNoClothIsOther) {
  EXPECT_EQ(family({"##", "##"}), "other");
  EXPECT_EQ(family({"..", ".."}), "other");
  EXPECT_EQ(family({"#"}), "other");
  EXPECT_EQ(weave_family(BitMatrix()), WeaveFamily::kOther);
  EXPECT_EQ(family({"#...", ".#..", "##..", "...."}), "other") << "threads that nothing holds";
}

TEST(WeaveFamily, HasAnIdForEach) {
  for (size_t i = 0; i < kWeaveFamilies; ++i)
    EXPECT_EQ(family_of_id(kWeaveFamilyNames[i].id), static_cast<WeaveFamily>(i));
  EXPECT_FALSE(family_of_id("brocade"));
}

}  // namespace
}  // namespace weftlight::analysis
