// The effect of finishes on yarns.

#include "design/finish.h"

#include <gtest/gtest.h>

#include <limits>

#include "../yarns.h"
#include "design/yarn_presets.h"

namespace weftlight::design {
namespace {

TEST(Finish, NoneLeavesEveryYarnUnchanged) {
  for (const Yarn& yarn : yarn_presets()) EXPECT_EQ(finished(yarn, {}), yarn) << yarn.name;
  Yarn odd;
  odd.diameter_mm = 99;  // out of range, and not clamped without a finish
  EXPECT_EQ(finished(odd, {}), odd);
}

TEST(Finish, RaisedIsAllNap) {
  const Yarn before = yarn_preset("Wool"), after = finished(before, {1, 0, 0});
  EXPECT_GT(after.lobes.fuzz, 0.8f);
  EXPECT_GT(after.lobes.fuzz_width, 0.9f);
  EXPECT_LT(after.groove_depth, 0.1f) << "the weave is hidden";
  EXPECT_LT(after.hairiness, before.hairiness) << "no streaks along a thread";
}

TEST(Finish, MercerisedCottonEqualsThePreset) {
  const Yarn a = finished(yarn_preset("Cotton"), {0, 1, 0}), b = yarn_preset("Mercerised cotton");
  EXPECT_NEAR(a.lobes.along_width, b.lobes.along_width, 0.01f);
  EXPECT_NEAR(a.lobes.layers, b.lobes.layers, 0.05f);
  EXPECT_NEAR(a.lobes.fuzz, b.lobes.fuzz, 0.005f);
  EXPECT_NEAR(a.hairiness, b.hairiness, 0.01f);
  EXPECT_NEAR(a.groove_depth, b.groove_depth, 0.01f);
  EXPECT_NEAR(a.flattening, b.flattening, 0.01f);
}

TEST(Finish, CalenderedIsFlatterAndBrighter) {
  const Yarn before = yarn_preset("Cotton"), after = finished(before, {0, 0, 1});
  EXPECT_LE(after.flattening, 0.6f * before.flattening + 1e-5f);
  EXPECT_LT(after.lobes.along_width, 0.6f * before.lobes.along_width);
  EXPECT_GT(after.lobes.layers, before.lobes.layers);
  EXPECT_LT(after.lobes.fuzz, 0.2f * before.lobes.fuzz);
}

TEST(Finish, WoolBloomsMoreThanCottonAndFilamentHardly) {
  const float wool = bloom(yarn_preset("Wool")), cotton = bloom(yarn_preset("Cotton")),
              silk = bloom(yarn_preset("Silk"));
  EXPECT_GT(wool, 1.05f);
  EXPECT_LT(wool, 1.3f);
  EXPECT_GT(wool, cotton);
  EXPECT_GT(cotton, silk);
  EXPECT_GE(silk, 1);
  EXPECT_LT(silk, 1.02f);
}

TEST(Finish, HalfwayLiesBetweenAndAllStayInRange) {
  const Yarn before = yarn_preset("Linen");
  for (const YarnField<Finish>& field : kFinishFields) {
    Finish half, whole, beyond;
    half.*field.member = 0.5f, whole.*field.member = 1, beyond.*field.member = 7;
    const float along[] = {before.lobes.along_width, finished(before, half).lobes.along_width,
                           finished(before, whole).lobes.along_width};
    EXPECT_EQ(along[0] < along[1], along[1] < along[2]) << field.facts.label;
    EXPECT_EQ(finished(before, beyond), finished(before, whole)) << field.facts.label;
    EXPECT_EQ(finished(before, whole), clamped(finished(before, whole))) << field.facts.label;
  }
  const float none = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(finished(before, {none, none, none}), before);
}

}  // namespace
}  // namespace weftlight::design
