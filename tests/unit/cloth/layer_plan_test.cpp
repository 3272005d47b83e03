// Multi-layer cloth: which threads lie above which, and what is visible of them.

#include "cloth/layer_plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <utility>

#include "cloth/centre_line.h"
#include "cloth/layers.h"
#include "cloth/maps.h"
#include "cloth/thread_scene.h"
#include "drafts.h"

namespace weftlight::cloth {

using design::Design;
using draft::BitMatrix, draft::Face, draft::Rgb, draft::System, draft::Threads, draft::complement, draft::kFromYarn;

namespace {

/// Two layers of plain weave, thread by thread; the even one is above where `above` says so, for each group of two.
template <class Above>
BitMatrix two_layers(int ends, int picks, const Above& above) {
  return cells_of(ends, picks, [&](int e, int p) {
    const bool first = e % 2 == 0;
    if (first != (p % 2 == 0)) return first == above(e / 2, p / 2);
    return (e / 2 + p / 2) % 2 == 0;
  });
}
BitMatrix double_weave(int ends, int picks) {
  return two_layers(ends, picks, [](int, int) { return true; });
}

/// Even threads of colour 0, odd ones of colour 1, in both systems.
Design two_colours(int ends, int picks, float spacing_mm, float thickness_mm) {
  Design d = design_of(ends, picks, spacing_mm, thickness_mm);
  d.draft.palette = {Rgb{0.9f, 0.1f, 0.1f}, Rgb{0.1f, 0.1f, 0.9f}};
  for (Threads* t : {&d.draft.warp, &d.draft.weft})
    for (size_t i = 0; i < t->color.size(); ++i) t->color[i] = static_cast<int>(i % 2);
  return d;
}

Cloth woven(const BitMatrix& cells, Face face = Face::kFront, float spacing_mm = kFromYarn) {
  return lay_out(two_colours(cells.cols(), cells.rows(), spacing_mm, 0.45f), cells, face, Period::kWholeDraft);
}

/// Fraction of red in a rectangle of the maps.
float red_fraction(const Maps& m, int x0, int x1, int y0, int y1) {
  float red = 0, all = 0;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x)
      red += m.coverage.at(x, y) * m.colour.at(x, y).r,
          all += m.coverage.at(x, y) * (m.colour.at(x, y).r + m.colour.at(x, y).b);
  return red / all;
}
float red_fraction(const Maps& m) { return red_fraction(m, 0, m.coverage.width, 0, m.coverage.height); }

TEST(Layers, PlainDoubleWeaveIsTwoClothsThatDoNotMeet) {
  for (const float spacing : {kFromYarn, 0.3f, 0.25f}) {
    const Cloth cloth = woven(double_weave(8, 8), Face::kFront, spacing);
    ASSERT_EQ(cloth.layers.size(), 2u) << spacing;
    ThreadScene scene(cloth), below(cloth, Face::kBack);
    float nearest = 1e3f;
    for (int j = 0; j < 200; ++j) {
      for (int i = 0; i < 200; ++i) {
        const glm::vec2 at(cloth.width_mm * static_cast<float>(i) / 200, cloth.depth_mm * static_cast<float>(j) / 200);
        const auto a = below.crossing_near(scene.thread_layer(0, -1), at),
                   b = scene.crossing_near(scene.thread_layer(1, 1), at);
        // From below, the underside of the upper layer is its top.
        const float under = -std::max(below.strand_top(a.warp, at.x, at.y, 2), below.strand_top(a.weft, at.y, at.x, 2));
        const float over = std::max(scene.strand_top(b.warp, at.x, at.y, 2), scene.strand_top(b.weft, at.y, at.x, 2));
        if (under < 1e3f && over > -1e3f) nearest = std::min(nearest, under - over);
      }
    }
    EXPECT_GE(nearest, 0) << "mm between the layers";
    EXPECT_LT(nearest, 0.5f * 0.45f) << "they touch, nearly";
  }
}

TEST(Layers, EndsOfBothLayersLieAboveOneAnotherAtTheirOwnSett) {
  const Cloth cloth = woven(double_weave(8, 12), Face::kFront, 0.3f);
  ASSERT_EQ(cloth.layers.size(), 2u);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_FLOAT_EQ(cloth.ends[i].centre_mm, cloth.ends[4 + i].centre_mm);
    EXPECT_FLOAT_EQ(cloth.ends[i].spacing_mm, 0.6f);
    EXPECT_GT(cloth.ends[i].width_mm, 0.45f) << "not jammed: as wide as in a cloth of 0.6 mm a thread";
  }
  EXPECT_FLOAT_EQ(cloth.width_mm, 8 * 0.3f);
  EXPECT_FLOAT_EQ(cloth.depth_mm, 12 * 0.3f);
}

TEST(Layers, EachFaceShowsItsOwnLayerAsPlainWeave) {
  for (const Face face : {Face::kFront, Face::kBack}) {
    const Cloth cloth = woven(double_weave(8, 8), face);
    const Maps maps = bake(cloth, {256, 256, 4});
    const float red = red_fraction(maps);
    EXPECT_GT(face == Face::kFront ? red : 1 - red, 0.97f);
    int warp = 0, covered = 0;
    for (size_t i = 0; i < maps.system.at_.size(); ++i)
      if (maps.coverage.at_[i] > 0.5f) ++covered, warp += maps.system.at_[i] == 0;
    EXPECT_NEAR(static_cast<float>(warp) / static_cast<float>(covered), 0.5f, 0.03f);
    const float all = static_cast<float>(maps.coverage.at_.size());
    EXPECT_GT(static_cast<float>(covered) / all, 0.97f);
  }
}

TEST(Layers, BlocksThatExchangeSwapTheirColours) {
  // Pockets of 16 threads a side, as squares of a chess board.
  const auto above = [](int e, int p) { return (e / 8 + p / 8) % 2 == 0; };
  const Cloth cloth = woven(two_layers(32, 32, above));
  ASSERT_EQ(cloth.layers.size(), 2u);
  const Maps front = bake(cloth, {512, 512, 4});
  const Maps back = bake(woven(two_layers(32, 32, above), Face::kBack), {512, 512, 4});
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 2; ++x) {
      // Inside the square; at its border threads pass from one layer to the other.
      const int x0 = x * 256 + 40, y0 = y * 256 + 40;
      const float red = red_fraction(front, x0, x0 + 176, y0, y0 + 176),
                  behind = red_fraction(back, x0, x0 + 176, y0, y0 + 176);
      EXPECT_GT(x == y ? red : 1 - red, 0.97f);
      EXPECT_GT(x == y ? 1 - behind : behind, 0.97f);
    }
  }
}

TEST(Layers, StitchedLayersStayLayersAndTheStitchHolds) {
  BitMatrix cells = double_weave(16, 16);
  cells.set(4, 5, true);  // a lower end over an upper pick
  cells.set(12, 13, true);
  const Cloth cloth = woven(cells);
  ASSERT_EQ(cloth.layers.size(), 2u);
  const ClothLayer lower = cloth.layers[1];
  const Cloth one = one_layer(cloth, 1), top = one_layer(cloth, 0);
  const CentreLines below = centre_lines(one), above = centre_lines(top);
  int over = 0;
  for (int e = 0; e < lower.ends; ++e) {
    for (int p = 0; p < lower.picks; ++p) {
      const float pick = above.at(System::kWeft, e, p);
      if (below.at(System::kWarp, e, p) <= pick) continue;
      ++over;
      EXPECT_TRUE((e == 2 && p == 2) || (e == 6 && p == 6)) << e << " " << p;
    }
  }
  EXPECT_EQ(over, 2) << "each stitch lifts its end over the pick, and nothing else is lifted";
  EXPECT_GT(red_fraction(bake(cloth, {256, 256, 4})), 0.9f);
}

TEST(Layers, ThreeLayersLieInTheirOrder) {
  const BitMatrix cells = cells_of(12, 12, [](int e, int p) {
    if (e % 3 != p % 3) return e % 3 < p % 3;
    return (e / 3 + p / 3) % 2 == 0;
  });
  const Cloth cloth = woven(cells);
  ASSERT_EQ(cloth.layers.size(), 3u);
  for (size_t i = 0; i + 1 < 3; ++i) {
    const ClothLayer &upper = cloth.layers[i], &lower = cloth.layers[i + 1];
    const auto level = [&](const ClothLayer& l) {
      return cloth.warp_level_mm[static_cast<size_t>(12 * l.first_pick + l.first_end)];
    };
    EXPECT_GT(level(upper), level(lower) + 0.45f);
  }
}

TEST(Layers, TwoFaceEndsForEachBackEnd) {
  // AAB in both systems.
  const BitMatrix cells = cells_of(12, 12, [](int e, int p) {
    const bool face_end = e % 3 != 2, face_pick = p % 3 != 2;
    if (face_end != face_pick) return face_end;
    if (!face_end) return (e / 3 + p / 3) % 2 == 0;
    return (e - e / 3 + p - p / 3) % 2 == 0;
  });
  const Cloth cloth = woven(cells, Face::kFront, 0.3f);
  ASSERT_EQ(cloth.layers.size(), 2u);
  EXPECT_EQ(cloth.layers[0].ends, 8);
  EXPECT_EQ(cloth.layers[1].ends, 4);
  EXPECT_NEAR(cloth.ends[0].spacing_mm, 0.45f, 1e-5f);
  EXPECT_NEAR(cloth.ends[8].spacing_mm, 0.9f, 1e-5f);
}

TEST(Layers, ClothThatHangsTogetherHasOne) {
  const auto layers = [](const BitMatrix& cells) { return find_layers(cells).layers; };
  EXPECT_EQ(layers(plain(16, 16)), 1);
  EXPECT_EQ(layers(twill(16, 16)), 1);
  EXPECT_EQ(layers(satin(16, 16)), 1);
  EXPECT_EQ(layers(scattered(60, 44, 77)), 1);
  EXPECT_EQ(layers(cells_of(16, 16, [](int e, int p) { return (e / 2 + p / 2) % 2 == 0; })), 1) << "basket";
  EXPECT_EQ(layers(cells_of(16, 16, [](int e, int) { return e % 2 == 0; })), 1) << "never woven";
  // Ends 7/1 and 1/7 alternating over one weft: a warp-backed weave, not a double cloth.
  EXPECT_EQ(layers(cells_of(16, 16,
                            [](int e, int p) {
                              const bool tied = (e / 2 * 5) % 8 == (p + (e % 2 ? 2 : 0)) % 8;
                              return tied != (e % 2 == 0);
                            })),
            1);
  EXPECT_EQ(layers(double_weave(16, 16)), 2);
  EXPECT_EQ(layers(complement(double_weave(16, 16))), 2);
}

TEST(Layers, TwillsAndShadedSatinsAreOneCloth) {
  // A 4/4 twill was once drawn as pockets of four threads.
  for (int repeat = 3; repeat <= 24; ++repeat) {
    for (int step = 1; step < repeat; ++step) {
      if (std::gcd(step, repeat) > 1) continue;  // some of these are not connected
      for (int up = 1; up < repeat; ++up) {
        BitMatrix cells(repeat, repeat);
        for (int p = 0; p < repeat; ++p)
          for (int k = 0; k < up; ++k) cells.set(p, (p * step + k) % repeat, true);
        EXPECT_EQ(find_layers(cells).layers, 1) << up << " of " << repeat << ", step " << step;
        if (repeat > 8 || up < 2 || up > repeat - 2) continue;
        cells.set(repeat / 2, repeat / 3, !cells.get(repeat / 2, repeat / 3));
        EXPECT_EQ(find_layers(cells).layers, 1) << up << " of " << repeat << ", step " << step << ", a cell painted";
      }
    }
  }
}

TEST(Layers, PaintedCellsPartAndJoinThemAsAWholeBakeDoes) {
  const BitMatrix apart = double_weave(8, 8), tied = plain(8, 8);
  for (const auto& [a, b] : {std::pair{apart, tied}, std::pair{tied, apart}}) {
    const Cloth before = woven(a), after = woven(b);
    Maps maps = bake(before, {128, 128, 8});
    rebake(maps, before, after);
    EXPECT_EQ(difference(maps, bake(after, {128, 128, 8})), "");
  }
}

}  // namespace
}  // namespace weftlight::cloth
