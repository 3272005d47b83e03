// Lobes that are fitted to traced fibres.

#include "render_data/fibre_lobes.h"

#include <gtest/gtest.h>

#include "../figures.h"
#include "../yarns.h"
#include "design/fibre_facts.h"

namespace weftlight::render_data {

using design::Lobes, design::Yarn, design::fibre_facts;

namespace {

TEST(FibreLobes, WithoutAFitTheDifferenceIsMeasured) {
  const Yarn& cotton = yarn_preset("Cotton");
  const FibreFit only_measured{.spp = 1, .max_tries = 0};
  const auto measured = lobes_of_fibres(cotton, only_measured);
  ASSERT_TRUE(measured);
  Yarn ikat = cotton;
  ikat.dye.stretches = {{4, draft::Rgb{0, 0, 0}}, {4, std::nullopt}};
  const auto of_ikat = lobes_of_fibres(ikat, only_measured);
  ASSERT_TRUE(of_ikat);
  EXPECT_EQ(of_ikat->octaves, measured->octaves) << "its swatch is dyed as any other";
  EXPECT_EQ(measured->lobes, cotton.lobes);
  EXPECT_EQ(measured->octaves, measured->octaves_before);
  EXPECT_GT(measured->octaves, 0.3f);
  EXPECT_LT(measured->octaves, 0.8f);
}

TEST(FibreLobes, AFitComesNearerAndKeepsWhatItIsTold) {
  Yarn dull = yarn_preset("Silk");
  dull.lobes.along_width = 0.1234567f, dull.lobes.across_width = 0.15f, dull.lobes.layers = 1, dull.lobes.inner = 0,
  dull.lobes.body = 1;
  const auto fitted = lobes_of_fibres(dull, {.spp = 1, .max_tries = 40});
  ASSERT_TRUE(fitted);
  figure("octaves before, now", fitted->octaves_before, fitted->octaves);
  EXPECT_LT(fitted->octaves, 0.7f * fitted->octaves_before);
  Yarn now = dull;
  now.lobes = fitted->lobes;
  EXPECT_EQ(fibre_facts(now).along_rad, fibre_facts(dull).along_rad) << "fitted again, it has the same fibres";
  Lobes others = fitted->lobes;
  others.across_width = dull.lobes.across_width, others.layers = dull.lobes.layers, others.inner = dull.lobes.inner,
  others.body = dull.lobes.body;
  EXPECT_EQ(others, dull.lobes) << "what is not fitted";
}

TEST(FibreLobes, MetalHasNoDye) {
  const auto refused = lobes_of_fibres(yarn_preset("Metallic"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, base::ErrorKind::kInput);
}

TEST(FibreLobes, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  const auto stopped = lobes_of_fibres(yarn_preset("Cotton"), {}, base::TaskProgress(stop.get_token()));
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, base::ErrorKind::kCancelled);
}

}  // namespace
}  // namespace weftlight::render_data
