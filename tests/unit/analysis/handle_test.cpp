// Weight and stiffness of a cloth from its yarns and sett, against a sum by hand.

#include "analysis/handle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../hand_drafts.h"
#include "design/fibre.h"
#include "design/yarn_presets.h"

namespace weftlight::analysis {

using design::Design, design::Yarn, design::straight_twill, design::with_count, design::yarn_presets;
using draft::Threads, draft::kFromYarn;

namespace {

/// Cotton singles of 20 tex, 40 by 40 a centimetre.
Design shirting() {
  Design d = straight_twill(8, 8);
  Yarn yarn = yarn_presets()[0];
  yarn.plies = 1, yarn.turns_per_m = 800, yarn.flattening = 0.7f, yarn.diameter_mm = 0.45f;
  d.yarns = {*with_count(yarn, "20 tex")};
  for (Threads* t : {&d.draft.warp, &d.draft.weft})
    t->spacing_mm.assign(t->color.size(), 0.25f), t->thickness_mm.assign(t->color.size(), kFromYarn);
  return d;
}

TEST(ClothHandle, AgreesWithACalculationByHand) {
  const ClothHandle hand = cloth_handle(shirting());
  // 4000 threads of 20 g a kilometre in a metre of each system, 1.05 times as long as the cloth: 168 g.
  EXPECT_NEAR(hand.kg_per_m2, 0.168, 0.001);
  // 20 tex are 0.01316 mm2 of cotton, 125.3 fibres of 1.05e-4 mm2. Free they bend with 6000 x 0.01316 x 1.05e-4 / 4 pi
  // = 6.597e-4 N mm2; cohesion 0.38 sqrt(125.3) = 4.254, at a twist of pi 0.167 x 0.8 = 0.419 1 + 3.254 x 0.419 / 0.469
  // = 3.907; four threads a mm: 10.31e-3 N mm.
  EXPECT_NEAR(hand.bending_n_m, 10.31e-6, 0.03e-6);
  // Cube root of 10.31e-6 N m over 0.168 x 9.81 N/m2.
  EXPECT_NEAR(hand.bending_length_mm, 18.4, 0.1);
}

TEST(ClothHandle, HeavierYarnsAndCloserSettsWeighMore) {
  const ClothHandle cloth = cloth_handle(shirting());
  Design open = shirting();
  for (float& mm : open.draft.weft.spacing_mm) mm = 0.5f;
  EXPECT_NEAR(cloth_handle(open).kg_per_m2 / cloth.kg_per_m2, 0.75, 1e-3);
  Design heavy = shirting();
  heavy.yarns[0] = *with_count(heavy.yarns[0], "80 tex");
  EXPECT_NEAR(cloth_handle(heavy).kg_per_m2 / cloth.kg_per_m2, 4, 0.02);
  EXPECT_GT(cloth_handle(heavy).bending_length_mm, 1.15 * cloth.bending_length_mm);
  // A thickness of the draft's counts as the yarn's own.
  Design given = shirting();
  const float thick = heavy.yarns[0].diameter_mm;
  given.draft.warp.thickness_mm.assign(given.draft.warp.color.size(), thick);
  given.draft.weft.thickness_mm.assign(given.draft.weft.color.size(), thick);
  EXPECT_NEAR(cloth_handle(given).kg_per_m2, cloth_handle(heavy).kg_per_m2, 1e-6);
}

TEST(ClothHandle, IfOneYarnIsFlatNoneIsBoundByGum) {
  Design organdie = shirting();
  organdie.yarns.push_back(organdie.yarns[0]);
  organdie.yarns[0].flattening = organdie.yarns[1].flattening = 1;
  organdie.draft.weft.yarn.assign(organdie.draft.weft.color.size(), 1);
  Design boiled = organdie, soft = organdie;
  boiled.yarns[0].flattening = 0.5f;
  soft.yarns[0].flattening = soft.yarns[1].flattening = 0.5f;
  EXPECT_GT(cloth_handle(organdie).bending_n_m, 2 * cloth_handle(soft).bending_n_m);
  EXPECT_NEAR(cloth_handle(boiled).bending_n_m / cloth_handle(soft).bending_n_m, 1, 1e-6);
}

TEST(ClothHandle, ASetCountGivesTheWeightWhateverTheThickness) {
  Design lofty = shirting();
  lofty.yarns[0].diameter_mm *= 1.5f;
  EXPECT_NEAR(cloth_handle(lofty).kg_per_m2, cloth_handle(shirting()).kg_per_m2, 1e-9);
  lofty.yarns[0].tex = 0;
  EXPECT_NEAR(cloth_handle(lofty).kg_per_m2 / cloth_handle(shirting()).kg_per_m2, 2.25, 0.05) << "in whole micrometres";
}

TEST(ClothHandle, CrepeTwistContractsTheClothAndMakesItLimp) {
  Design silk = shirting();
  for (const Yarn& ready : yarn_presets())
    if (ready.name == "Silk") silk.yarns[0] = *with_count(ready, "66 den");
  Yarn& yarn = silk.yarns[0];
  yarn.plies = 1, yarn.flattening = 0.7f, yarn.unevenness = 4;
  const auto twisted = [&](float tangent) {
    yarn.turns_per_m = 1000 * tangent / (std::numbers::pi_v<float> * yarn.diameter_mm);
    return cloth_handle(silk);
  };
  const ClothHandle organzine = twisted(0.19f), crepe = twisted(0.31f);
  EXPECT_NEAR(crepe.kg_per_m2 / organzine.kg_per_m2, 1.12, 1e-3) << "a longer path";
  // 54.7 filaments, 1 + (0.38 sqrt(54.7) - 1) x 0.19 / 0.24 times as stiff as loose ones, and the path is longer.
  EXPECT_NEAR(organzine.bending_n_m / crepe.bending_n_m, 1.12 * 2.434, 0.02);
  EXPECT_LT(crepe.bending_length_mm, 0.75 * organzine.bending_length_mm);
  // The twist of staple yarn binds its fibres; plying balances it.
  for (const auto& [plies, unevenness] : {std::pair(1, 12.0f), std::pair(2, 4.0f)}) {
    yarn.plies = plies, yarn.unevenness = unevenness;
    EXPECT_GT(twisted(0.31f).bending_n_m, organzine.bending_n_m);
  }
}

TEST(ClothHandle, IsZeroWithoutThreads) {
  const ClothHandle hand = cloth_handle(Design{});
  EXPECT_EQ(hand.kg_per_m2, 0);
  EXPECT_EQ(hand.bending_length_mm, 0);
}

}  // namespace
}  // namespace weftlight::analysis
