// Unusual drafts of unusual sizes: maps, windows and rebaked parts are consistent. (Under the sanitizers, this is also
// where a read past a thread's samples would show.)

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "drafts.h"

namespace weftlight::cloth {

using design::Design;
using draft::BitMatrix, draft::CellRect, draft::Face, draft::Threads;

namespace {

float spacing_or_thickness(std::mt19937& random) {
  constexpr float kValues[] = {0.0f, 1e-4f, 0.02f, 0.3f, 0.5f, 0.5f, 0.5f, 1.7f, 40.0f};
  return kValues[random() % std::size(kValues)];
}

Design odd_design(std::mt19937& random, int ends, int picks) {
  Design d = design_of(ends, picks, 0.5f, 0.45f);
  for (Threads* t : {&d.draft.warp, &d.draft.weft}) {
    for (float& s : t->spacing_mm) s = spacing_or_thickness(random);
    for (float& s : t->thickness_mm) s = spacing_or_thickness(random);
  }
  return d;
}

int wrap(int i, int n) { return (i % n + n) % n; }

void expect_numbers(const Maps& m) {
  for (const float z : m.height_mm.at_) ASSERT_TRUE(std::isfinite(z));
  for (const float c : m.coverage.at_) ASSERT_TRUE(c >= 0 && c <= 1);
  for (const float o : m.occlusion.at_) ASSERT_TRUE(o >= 0 && o <= 1);
  for (const Slope& s : m.slope.at_) ASSERT_TRUE(std::isfinite(s.x) && std::isfinite(s.y));
  for (const Direction& t : m.tangent.at_) ASSERT_NEAR(std::hypot(t.x, t.y, t.z), 1, 1e-3);
}

void expect_window_of(const Maps& all, const Maps& part, const TexelRect& r) {
  const int w = all.height_mm.width, h = all.height_mm.height;
  for (int y = 0; y < part.height_mm.height; ++y) {
    for (int x = 0; x < part.height_mm.width; ++x) {
      const int ax = wrap(r.x0 + x, w), ay = wrap(r.y0 + y, h);
      ASSERT_EQ(part.height_mm.at(x, y), all.height_mm.at(ax, ay));
      for (size_t k = 0; k < all.horizon.size(); ++k) ASSERT_EQ(part.horizon[k].at(x, y), all.horizon[k].at(ax, ay));
    }
  }
}

class OddCloths : public testing::TestWithParam<unsigned> {};

TEST_P(OddCloths, hold_together) {
  std::mt19937 random(GetParam());
  const auto upto = [&random](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const int ends = 1 + upto(GetParam() % 3 ? 12 : 70), picks = 1 + upto(GetParam() % 4 ? 12 : 70);
  const Design d = odd_design(random, ends, picks);
  BitMatrix cells = scattered(ends, picks, GetParam());
  const Face face = upto(2) ? Face::kFront : Face::kBack;
  const MapsSize size{1 + upto(90), 1 + upto(90), upto(9), 1 + upto(2)};
  Maps maps = bake(lay_out(d, cells, face, Period::kWholeDraft), size);
  expect_numbers(maps);
  for (int k = 0; k < 3; ++k) {
    const TexelRect r{upto(300) - 150, upto(300) - 150, 0, 0};
    const TexelRect window{r.x0, r.y0, r.x0 + 1 + upto(size.width), r.y0 + 1 + upto(size.height)};
    const Cloth cloth = lay_out(d, cells, face, Period::kWholeDraft);
    expect_window_of(maps, bake(cloth, size, window), window);
    const CellRect dirty{upto(ends), 0, upto(picks), 0};
    const CellRect whole{dirty.end0, dirty.end0 + 1 + upto(ends - dirty.end0), dirty.pick0,
                         dirty.pick0 + 1 + upto(picks - dirty.pick0)};
    for (int p = whole.pick0; p < whole.pick1; ++p)
      for (int e = whole.end0; e < whole.end1; ++e) cells.set(p, e, !cells.get(p, e));
    const Cloth after = lay_out(d, cells, face, Period::kWholeDraft);
    rebake(maps, cloth, after);
    ASSERT_EQ(difference(maps, bake(after, size)), "")
        << ends << " x " << picks << " to " << size.width << " x " << size.height;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, OddCloths, testing::Range(1u, 41u));

}  // namespace
}  // namespace weftlight::cloth
