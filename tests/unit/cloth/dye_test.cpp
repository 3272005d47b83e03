// Colours along threads in the maps of a cloth.

#include <gtest/gtest.h>

#include "cloth/layers.h"
#include "drafts.h"

namespace weftlight::cloth {

using design::Dye;
using draft::Face, draft::System, draft::kFromYarn;

namespace {

const Rgb kRed{1, 0, 0}, kBlue{0, 0, 1};

Design dyed(int ends, int picks, Dye dye, System system) {
  Design d = design_of(ends, picks, 0.5f, 0.4f);
  d.yarns.emplace_back().dye = std::move(dye);
  d.draft.threads(system).yarn.assign(static_cast<size_t>(d.draft.threads(system).size()), 1);
  return d;
}

Dye red_then_blue(int red, int blue, int shift = 0) { return {{{red, kRed, false}, {blue, kBlue, false}}, shift, 0}; }

TEST(DyedCloth, HasTheColourOfEachCrossingInItsMaps) {
  constexpr int kSide = 8, kTexels = 16;  // texels a thread
  for (const System system : {System::kWarp, System::kWeft}) {
    const Design d = dyed(kSide, kSide, red_then_blue(3, 1, 1), system);
    for (const Face face : {Face::kFront, Face::kBack}) {
      const Cloth cloth = lay_out(d, twill(kSide, kSide), face, Period::kWholeDraft);
      const Maps maps = bake(cloth, {kSide * kTexels, kSide * kTexels, 0});
      for (int p = 0; p < kSide; ++p)
        for (int e = 0; e < kSide; ++e) {
          if (cloth.up.get(p, e) != (system == System::kWarp)) continue;
          const int thread = system == System::kWarp ? e : p, crossed = system == System::kWarp ? p : e;
          const Linear& c = maps.colour.at(e * kTexels + kTexels / 2, p * kTexels + kTexels / 2);
          const bool blue = (crossed + thread) % 4 == 3;
          EXPECT_EQ(c.b > c.r, blue) << "thread " << thread << ", crossing " << crossed;
          EXPECT_LT(std::min(c.b, c.r), 0.05f);
        }
    }
  }
}

TEST(DyedCloth, CountsTheThreadsOfTheDraftInEveryLayer) {
  // Two plain weaves, one above the other: threads 0, 2, 4... above.
  const BitMatrix cells = cells_of(8, 8, [](int e, int p) {
    if (e % 2 != p % 2) return e % 2 == 0;  // the upper ends are over all lower picks
    return (e / 2 + p / 2) % 2 == 0;
  });
  const Design d = dyed(8, 8, red_then_blue(7, 1), System::kWarp);
  const Cloth cloth = lay_out(d, cells, Face::kFront, Period::kWholeDraft);
  ASSERT_EQ(layer_count(cloth), 2);
  for (int thread = 0; thread < 8; ++thread)
    for (const ThreadBody& pick : cloth.picks) {
      if (layer_of(cloth, System::kWarp, thread) !=
          layer_of(cloth, System::kWeft, static_cast<int>(&pick - cloth.picks.data())))
        continue;
      const Linear& c = colour_along(cloth, System::kWarp, thread, pick.centre_mm);
      EXPECT_EQ(c.b > c.r, pick.place == 7) << thread << " over pick " << pick.place;
    }
}

TEST(DyedCloth, IsItsMeanColourAsAWhole) {
  const Cloth cloth =
      lay_out(dyed(4, 4, red_then_blue(3, 1), System::kWarp), plain(4, 4), Face::kFront, Period::kWholeDraft);
  EXPECT_FLOAT_EQ(cloth.ends[0].colour.r, 0.75f);
  EXPECT_FLOAT_EQ(cloth.ends[0].colour.b, 0.25f);
}

TEST(DyedCloth, WrapsAlongThePeriod) {
  const Cloth cloth =
      lay_out(dyed(4, 4, red_then_blue(3, 1), System::kWarp), plain(4, 4), Face::kFront, Period::kWholeDraft);
  for (const int turn : {-1, 0, 1}) {
    const float from = static_cast<float>(turn) * cloth.depth_mm;
    EXPECT_GT(colour_along(cloth, System::kWarp, 1, from + 0.1f).r, 0.9f);
    EXPECT_GT(colour_along(cloth, System::kWarp, 1, from + cloth.depth_mm - 0.1f).b, 0.9f);
  }
}

}  // namespace
}  // namespace weftlight::cloth
