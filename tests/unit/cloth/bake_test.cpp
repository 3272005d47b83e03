#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../centre_height.h"
#include "design/fibre.h"
#include "drafts.h"

namespace weftlight::cloth {

using design::Design, design::Twist;
using draft::BitMatrix, draft::Face, draft::System, draft::complement, draft::kFromYarn;

namespace {

Cloth whole(const Design& d, const BitMatrix& cells, Face face = Face::kFront) {
  return lay_out(d, cells, face, Period::kWholeDraft);
}

bool all_finite(const Maps& m) {
  for (size_t i = 0; i < m.height_mm.at_.size(); ++i) {
    const Linear& c = m.colour.at_[i];
    const Direction& t = m.tangent.at_[i];
    for (float v : {m.height_mm.at_[i], m.coverage.at_[i], m.groove.at_[i], m.slope.at_[i].x, m.slope.at_[i].y, c.r,
                    c.g, c.b, t.x, t.y, t.z, m.occlusion.at_[i]})
      if (!std::isfinite(v)) return false;
    const float length = t.x * t.x + t.y * t.y + t.z * t.z;
    if (std::abs(length - 1.0f) > 1e-4f) return false;
    if (c.r < 0 || c.r > 1 || m.coverage.at_[i] < 0 || m.coverage.at_[i] > 1 || m.groove.at_[i] < 0 ||
        m.groove.at_[i] > 1 || m.occlusion.at_[i] < 0 || m.occlusion.at_[i] > 1)
      return false;
  }
  return true;
}

TEST(LayOut, ANapFillsTheGapsAndHidesTheRelief) {
  Design d = design_of(8, 8, 0.5f, 0.3f);
  const auto relief_and_gaps = [&] {
    const Maps maps = bake(lay_out(d, twill(8, 8), Face::kFront, Period::kWholeDraft), {128, 128, 8});
    const auto [low, high] = std::minmax_element(maps.height_mm.at_.begin(), maps.height_mm.at_.end());
    float covered = 0;
    for (const float c : maps.coverage.at_) covered += c / static_cast<float>(maps.coverage.at_.size());
    return std::pair{*high - *low, covered};
  };
  const auto [relief, covered] = relief_and_gaps();
  d.finish.raised = 1;
  const auto [nap_relief, nap_covered] = relief_and_gaps();
  EXPECT_LT(covered, 0.95f);
  EXPECT_GT(nap_covered, 0.999f);
  EXPECT_LT(nap_relief, 0.4f * relief);
}

TEST(LayOut, ACalenderedClothHasFlatterThreadsAtTheSameSett) {
  for (const float spacing : {0.8f, kFromYarn}) {
    Design d = design_of(4, 4, spacing, 0.3f);  // ends of 0.5 mm
    d.draft.warp.thickness_mm.assign(4, kFromYarn);
    const Cloth loomstate = lay_out(d, plain(4, 4), Face::kFront, Period::kWholeDraft);
    d.finish.calendered = 1;
    const Cloth pressed = lay_out(d, plain(4, 4), Face::kFront, Period::kWholeDraft);
    EXPECT_EQ(pressed.width_mm, loomstate.width_mm);
    EXPECT_LT(pressed.ends[0].height_mm, loomstate.ends[0].height_mm);
    EXPECT_GE(pressed.ends[0].width_mm, loomstate.ends[0].width_mm);
    EXPECT_GT(pressed.yarns[0].lobes.layers, loomstate.yarns[0].lobes.layers);
  }
}

TEST(LayOut, ThreadsLieSideBySideInMillimetres) {
  const Cloth c = whole(design_of(4, 3, 0.5f, 0.3f), plain(4, 3));
  EXPECT_FLOAT_EQ(c.width_mm, 2.0f);
  EXPECT_FLOAT_EQ(c.depth_mm, 1.5f);
  EXPECT_FLOAT_EQ(c.ends[0].centre_mm, 0.25f);
  EXPECT_FLOAT_EQ(c.ends[3].centre_mm, 1.75f);
  // Flattened, with the area of the round thread.
  EXPECT_GT(c.ends[0].width_mm, 0.3f);
  EXPECT_NEAR(c.ends[0].width_mm * c.ends[0].height_mm, 0.09f, 1e-5f);
}

TEST(LayOut, YarnsWithoutSpacingTouchWithSlightGaps) {
  const Cloth c = whole(design_of(4, 4, kFromYarn, kFromYarn), plain(4, 4));
  for (const auto* side : {&c.ends, &c.picks})
    for (const ThreadBody& t : *side) {
      EXPECT_LT(t.width_mm, t.spacing_mm);
      EXPECT_GT(t.width_mm, 0.85f * t.spacing_mm);
    }
}

/// Of a thread's section over that of the square around a round thread.
float section_area(const ThreadBody& thread) {
  constexpr int kParts = 2000;
  float sum = 0;
  for (int i = 0; i < kParts; ++i)
    sum += thread_formulas::section_top((static_cast<float>(i) + 0.5f) / kParts, thread.squareness);
  return thread.width_mm * thread.height_mm * sum / kParts * 4 / 3.14159265f;
}

TEST(LayOut, JammedThreadsFillTheirCornersArePressedTogetherAndThenGetTaller) {
  constexpr float kHigh = 0.3578f;  // of 0.4 mm at a roundness of 0.8
  const auto end = [](float spacing, float fibre, float turns = 0) {
    Design d = design_of(2, 2, spacing, 0.4f);
    d.yarns[0].flattening = 0.8f, d.yarns[0].diameter_mm = 0.4f, d.yarns[0].turns_per_m = turns;
    d.yarns[0].tex = fibre * design::tex_of(d.yarns[0]) / static_cast<float>(design::packing_fraction(d.yarns[0]));
    return whole(d, plain(2, 2)).ends[0];
  };
  const ThreadBody free = end(0.42f, 0.3f), loose = end(0.36f, 0.3f), dense = end(0.36f, 0.75f);
  EXPECT_EQ(end(0.45f, 0.3f).squareness, 0) << "it has its room";
  EXPECT_NEAR(free.height_mm, kHigh, 1e-3f);
  EXPECT_GT(free.squareness, 0.3f);
  EXPECT_NEAR(section_area(free), 0.16f, 1e-3f) << "its corners hold what its sides have lost";
  EXPECT_FLOAT_EQ(loose.width_mm, 0.36f);
  EXPECT_NEAR(loose.height_mm, free.height_mm, 1e-3f) << "its fibres have room";
  EXPECT_NEAR(section_area(dense), 0.16f, 1e-3f) << "its section keeps its area";
  EXPECT_NEAR(section_area(end(0.30f, 0.6f)), 0.8f * 0.16f, 1e-3f) << "until three quarters of it are fibre";
  EXPECT_NEAR(end(0.36f, 0.3f, 400).height_mm, dense.height_mm, 1e-3f) << "twist holds the fibres";
}

TEST(LayOut, RepeatIsTheSmallestTile) {
  const Cloth c = lay_out(design_of(8, 12, 0.5f, 0.4f), plain(8, 12), Face::kFront, Period::kRepeat);
  EXPECT_EQ(c.ends.size(), 2u);
  EXPECT_EQ(c.picks.size(), 2u);
  EXPECT_FLOAT_EQ(c.width_mm, 1.0f);
}

TEST(LayOut, BackIsTheComplementInTheSameEndOrder) {
  const Design d = design_of(5, 7, 0.5f, 0.4f);
  const BitMatrix cells = scattered(5, 7, 3);
  const Cloth front = whole(d, cells), back = whole(d, cells, Face::kBack);
  for (int p = 0; p < 7; ++p)
    for (int e = 0; e < 5; ++e) EXPECT_NE(front.up.get(p, e), back.up.get(p, e));
  EXPECT_EQ(back.up, complement(cells));
  for (float s : {0.0f, 0.31f, 1.2f, 2.9f})
    EXPECT_FLOAT_EQ(centre_height_mm(front, System::kWarp, 2, s), -centre_height_mm(back, System::kWarp, 2, s));
}

TEST(Bake, CoverageIsTheShareOfTheArea) {
  for (int size : {64, 200, 301}) {
    const Cloth c = whole(design_of(6, 6, 0.5f, 0.2f), plain(6, 6));
    const Maps m = bake(c, {size, size, 0, 1});
    double sum = 0;
    for (float v : m.coverage.at_) sum += static_cast<double>(v);
    const double open = 1.0 - static_cast<double>(c.ends[0].width_mm) / 0.5;
    EXPECT_NEAR(sum / (size * size), 1.0 - open * open, 1e-4) << size;
  }
}

TEST(Bake, WarpIsOnTopWhereTheCellsSaySo) {
  const BitMatrix cells = scattered(9, 7, 11);
  const Cloth c = whole(design_of(9, 7, 0.5f, 0.45f), cells);
  const Maps m = bake(c, {9 * 20, 7 * 20, 0, 1});
  for (int p = 0; p < 7; ++p)
    for (int e = 0; e < 9; ++e) {
      EXPECT_EQ(m.system.at(e * 20 + 10, p * 20 + 10), cells.get(p, e) ? 0 : 1);
      EXPECT_EQ(m.thread.at(e * 20 + 10, p * 20 + 10), static_cast<uint32_t>(cells.get(p, e) ? e : p));
    }
}

TEST(Bake, BackFaceShowsTheComplement) {
  const BitMatrix cells = scattered(8, 8, 5);
  const Design d = design_of(8, 8, 0.5f, 0.45f);
  const Maps front = bake(whole(d, cells), {160, 160, 0, 1});
  const Maps back = bake(whole(d, cells, Face::kBack), {160, 160, 0, 1});
  for (int p = 0; p < 8; ++p)
    for (int e = 0; e < 8; ++e)
      EXPECT_NE(front.system.at(e * 20 + 10, p * 20 + 10), back.system.at(e * 20 + 10, p * 20 + 10));
}

TEST(Bake, StraightThreadHasTheNormalsOfItsEllipse) {
  // Wefts of no thickness: the ends lie straight.
  Design d = design_of(1, 1, 1.0f, 0.8f);
  d.draft.weft.thickness_mm = {0.0f};
  d.yarns[0].flattening = 1.0f;  // round
  const Cloth c = whole(d, plain(1, 1));
  const int n = 400;
  const Maps m = bake(c, {n, 4, 0, 1});
  for (int x = 0; x < n; ++x) {
    const double u = ((x + 0.5) / n - 0.5) / 0.4;  // across the radius
    if (std::abs(u) > 0.95) continue;
    EXPECT_NEAR(static_cast<double>(m.slope.at(x, 2).x), u / std::sqrt(1 - u * u), 0.02 + 0.02 * std::abs(u));
    EXPECT_NEAR(static_cast<double>(m.slope.at(x, 2).y), 0.0, 1e-6);
  }
}

TEST(Bake, TwistRunsToTheRightForZAndToTheLeftForS) {
  for (Twist twist : {Twist::kZ, Twist::kS}) {
    Design d = design_of(2, 2, 0.6f, 0.5f);
    d.yarns[0].twist = twist;
    const Maps m = bake(whole(d, plain(2, 2)), {128, 128, 0, 1});
    const float hand = twist == Twist::kZ ? 1.0f : -1.0f;
    EXPECT_GT(m.tangent.at(32, 32).x * hand, 0.05f);  // an end is on top: axis +y, leaning to +x for Z
    EXPECT_EQ(m.system.at(32, 32), 0);
    EXPECT_LT(m.tangent.at(96, 32).y * hand, -0.05f);  // a pick: axis +x, leaning to -y for Z
    EXPECT_EQ(m.system.at(96, 32), 1);
  }
}

TEST(Bake, TheMiddleOfALongFloatStandsHigher) {
  const Cloth c = whole(design_of(8, 8, 0.5f, 0.45f), satin(8, 8));
  // End 0 is down at pick 0 only.
  const auto at = [&](int pick) {
    return centre_height_mm(c, System::kWarp, 0, c.picks[static_cast<size_t>(pick)].centre_mm);
  };
  EXPECT_LT(at(0), 0.0f);
  EXPECT_GT(at(2), at(1));
  EXPECT_GT(at(4), at(2));
  EXPECT_LT(at(4) - at(1), c.ends[0].height_mm);  // bounded by the tightness of the weave
}

TEST(Bake, TilesMeetWithoutASeam) {
  const Cloth c = whole(design_of(8, 8, 0.5f, 0.45f), satin(8, 8));
  const Maps m = bake(c, {512, 512, 8, 1});
  // Steps over the border are like steps inside.
  const auto column_step = [&](int x0, int x1) {
    double sum = 0;
    for (int y = 0; y < 512; ++y)
      sum += std::abs(static_cast<double>(m.height_mm.at(x0, y)) - static_cast<double>(m.height_mm.at(x1, y))) +
             std::abs(static_cast<double>(m.groove.at(x0, y)) - static_cast<double>(m.groove.at(x1, y)));
    return sum / 512;
  };
  // The border is at the edge of a thread, as is column 64.
  EXPECT_LT(column_step(511, 0), 2.0 * column_step(63, 64) + 0.01);
  const auto row_step = [&](int y0, int y1) {
    double sum = 0;
    for (int x = 0; x < 512; ++x)
      if (m.system.at(x, y0) == 0 && m.system.at(x, y1) == 0)
        sum += std::abs(static_cast<double>(m.groove.at(x, y0)) - static_cast<double>(m.groove.at(x, y1))) +
               std::abs(static_cast<double>(m.colour.at(x, y0).r) - static_cast<double>(m.colour.at(x, y1).r));
    return sum / 512;
  };
  EXPECT_LT(row_step(511, 0), 1.3 * row_step(255, 256) + 0.001);
}

TEST(Bake, WholeRepeatsFurtherOnTheDraftIsTheSameTile) {
  const Design d = design_of(16, 16, 0.5f, 0.45f);
  const auto tile = [&](int shift) {
    const BitMatrix cells = cells_of(16, 16, [&](int e, int p) { return ((e + shift) * 5) % 8 != (p + shift) % 8; });
    return bake(lay_out(d, cells, Face::kFront, Period::kRepeat), {128, 128, 8, 1});
  };
  EXPECT_EQ(difference(tile(0), tile(8)), "");
  EXPECT_EQ(difference(tile(0), tile(64)), "");
}

TEST(Bake, BitsDoNotDependOnTheNumberOfThreads) {
  const Cloth c = whole(design_of(12, 10, 0.5f, 0.45f), scattered(12, 10, 7));
  MapsSize size{200, 150, 16, 1};
  const Maps one = bake(c, size);
  for (int threads : {2, 3, 7}) {
    size.threads = threads;
    EXPECT_EQ(difference(one, bake(c, size)), "") << threads;
  }
}

TEST(Bake, CoarseMapsAreRightOnAverage) {
  // 96 x 96 threads in 40 x 33 texels against a fine bake.
  Design d = design_of(96, 96, 0.5f, 0.42f);
  const Cloth c = whole(d, scattered(96, 96, 23));
  const auto mean = [&](int w, int h) {
    const Maps m = bake(c, {w, h, 0, 2});
    std::array<double, 5> sum{};
    for (size_t i = 0; i < m.coverage.at_.size(); ++i) {
      const double cover = static_cast<double>(m.coverage.at_[i]);
      const Linear& l = m.colour.at_[i];
      const double value[5] = {1, static_cast<double>(l.r * m.groove.at_[i]),
                               static_cast<double>(l.b * m.groove.at_[i]), static_cast<double>(m.slope.at_[i].x),
                               static_cast<double>(m.slope.at_[i].y)};
      for (size_t k = 0; k < 5; ++k) sum[k] += cover * value[k] / static_cast<double>(m.coverage.at_.size());
    }
    return sum;
  };
  const auto fine = mean(96 * 16, 96 * 16), coarse = mean(40, 33);
  EXPECT_NEAR(coarse[0], fine[0], 1e-3);
  EXPECT_NEAR(coarse[1], fine[1], 0.02 * fine[1]);
  EXPECT_NEAR(coarse[2], fine[2], 0.02 * fine[2]);
  EXPECT_NEAR(coarse[3], fine[3], 0.01);
  EXPECT_NEAR(coarse[4], fine[4], 0.01);
}

TEST(Bake, ExtremeThreadsStayFinite) {
  for (float thickness : {0.0f, 1e-6f, 50.0f, 1e9f, kFromYarn})
    for (float spacing : {0.0f, 1e-7f, 0.5f, 1e8f, kFromYarn})
      for (int n : {1, 3}) {
        const Cloth c = whole(design_of(n, n, spacing, thickness), plain(n, n));
        const Maps m = bake(c, {32, 16, 4, 1});
        EXPECT_TRUE(all_finite(m)) << thickness << " mm at " << spacing << " mm, " << n;
        EXPECT_GT(m.width_mm, 0.0f);
      }
  Design d = design_of(2, 2, std::nanf(""), std::nanf(""));
  d.yarns[0].turns_per_m = 1e30f;
  d.yarns[0].fibre_um = 0;
  d.yarns[0].plies = 99;
  EXPECT_TRUE(all_finite(bake(whole(d, plain(2, 2)), {32, 32, 4, 1})));
}

TEST(Bake, AllWarpAllWeftAndNoThreads) {
  for (bool up : {false, true}) {
    const Cloth c = whole(design_of(5, 4, 0.5f, 0.45f), cells_of(5, 4, [&](int, int) { return up; }));
    const Maps m = bake(c, {100, 80, 8, 1});
    EXPECT_TRUE(all_finite(m));
    for (int y = 10; y < 80; y += 20)
      for (int x = 10; x < 100; x += 20) EXPECT_EQ(m.system.at(x, y), up ? 0 : 1);
  }
  const Maps none = bake(Cloth{}, {8, 8, 4, 1});
  EXPECT_EQ(none.horizon.size(), 4u);
  for (float v : none.coverage.at_) EXPECT_EQ(v, 0.0f);
}

TEST(Bake, SizesAreClamped) {
  const Cloth c = whole(design_of(2, 2, 0.5f, 0.4f), plain(2, 2));
  const Maps m = bake(c, {-5, 0, 1000, 1});
  EXPECT_EQ(m.height_mm.width, 1);
  EXPECT_EQ(m.height_mm.height, 1);
  EXPECT_EQ(m.azimuths, 64);
}

TEST(Bake, ManyThreadsKeepTheirIndex) {
  // Beyond 127, 255 and 65,535 threads, which narrow index types would fold.
  const int n = 66000;
  const Cloth c = whole(design_of(n, 1, 0.5f, 0.45f), cells_of(n, 1, [](int, int) { return true; }));
  const Maps m = bake(c, {16384, 1, 0, 1});
  EXPECT_GT(m.thread.at(16383, 0), 65990u);
  EXPECT_TRUE(all_finite(m));
}

}  // namespace
}  // namespace weftlight::cloth
