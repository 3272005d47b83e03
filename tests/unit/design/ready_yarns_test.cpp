// The ready yarns: what a weaver chooses from, their figures, and the table in docs/yarns.md.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <set>
#include <sstream>

#include "../yarns.h"
#include "design/fibre.h"
#include "design/fibre_facts.h"
#include "design/written_count.h"
#include "paths.h"

namespace weftlight::design {
namespace {

/// Degrees that the fibres of the surface lie at to the thread, by its last twist.
double angle_deg(const Yarn& yarn) {
  const double radius_mm = 0.5 * static_cast<double>(yarn.diameter_mm);
  return std::atan(2 * std::numbers::pi * radius_mm * static_cast<double>(yarn.turns_per_m) / 1000) * 180 /
         std::numbers::pi;
}

TEST(ReadyYarns, StandByFibreTheUsualOneFirst) {
  std::set<std::string> names;
  std::set<Fibre> seen;
  int last = 0;
  for (const Yarn& yarn : ready_yarns()) {
    EXPECT_TRUE(names.insert(yarn.name).second) << yarn.name;
    EXPECT_GE(static_cast<int>(yarn.fibre), last) << yarn.name;
    last = static_cast<int>(yarn.fibre);
    if (seen.insert(yarn.fibre).second) {
      EXPECT_EQ(yarn, ready_yarn(yarn.fibre)) << yarn.name;
    }
  }
  EXPECT_EQ(seen.size(), static_cast<size_t>(kFibres));
  for (const char* name : {"Combed cotton", "Reeled silk", "Woollen yarn", "Spun polyester"})
    EXPECT_TRUE(names.contains(name)) << name;
}

// A file goes by the usual yarns, which keep their number and their names.
TEST(ReadyYarns, AddNoFibre) {
  EXPECT_EQ(yarn_presets().size(), static_cast<size_t>(kFibres));
  for (Yarn yarn : ready_yarns()) {
    const Yarn named = yarn;
    yarn.fibre = Fibre::kViscose, yarn.section = CrossSection::kFlat;
    EXPECT_EQ(with_recognised_fibre(yarn), named) << named.name << ", from a file without names";
  }
  for (const Yarn& usual : yarn_presets())
    if (usual.fibre != Fibre::kPolyester) {
      EXPECT_EQ(fibre_name(usual.fibre), usual.name);
    }
  EXPECT_STREQ(fibre_name(Fibre::kPolyester), "Polyester") << "spun or filament";
}

struct Sold {
  const char *yarn, *count;
};
constexpr Sold kSold[] = {{"Cotton", "Ne 8/2"},
                          {"Combed cotton", "Ne 20/2"},
                          {"Mercerised cotton", "Ne 10/2"},
                          {"Linen", "16/2 lea"},
                          {"Silk", "Nm 30/2"},
                          {"Reeled silk", "Nm 47"},
                          {"Wool", "Nm 28/2"},
                          {"Woollen yarn", "Nm 8/2"},
                          {"Viscose", "300 den"},
                          {"Polyester filament", "150 den"},
                          {"Spun polyester", "Ne 30/2"},
                          {"Metallic", "12.9 tex"}};

TEST(ReadyYarns, CountThicknessAndTwistAgree) {
  ASSERT_EQ(std::size(kSold), ready_yarns().size());
  for (const Sold& sold : kSold) {
    const Yarn& yarn = yarn_preset(sold.yarn);
    ASSERT_EQ(yarn.name, sold.yarn);
    const std::optional<Yarn> again = with_count(yarn, sold.count);
    ASSERT_TRUE(again) << yarn.name;
    EXPECT_NEAR(again->tex / yarn.tex, 1, 3e-3) << yarn.name;
    EXPECT_EQ(again->plies, yarn.plies) << yarn.name;
  }
  for (size_t i = 0; i < std::size(kSold); ++i) EXPECT_EQ(written_count(ready_yarns()[i]), kSold[i].count);
  for (const Yarn& yarn : ready_yarns()) {
    EXPECT_EQ(clamped(yarn), yarn) << yarn.name;
    if (yarn.fibre == Fibre::kMetallic) continue;  // a folded film
    EXPECT_GT(packing_fraction(yarn), 0.35) << yarn.name;
    EXPECT_LT(packing_fraction(yarn), 0.7) << yarn.name;
    EXPECT_GT(angle_deg(yarn), 2) << yarn.name;
    EXPECT_LT(angle_deg(yarn), 25) << yarn.name;
    EXPECT_NEAR(with_hairiness(yarn, yarn.hairiness).lobes.fuzz, yarn.lobes.fuzz, 0.02f * yarn.lobes.fuzz + 5e-4f)
        << yarn.name << ": fuzz follows the hairiness";
  }
}

TEST(ReadyYarns, DifferAsTheirSpinningDoes) {
  const auto expect_smoother = [](const char* smooth, const char* rough) {
    const Yarn &a = yarn_preset(smooth), &b = yarn_preset(rough);
    ASSERT_EQ(a.name, smooth);
    ASSERT_EQ(b.name, rough);
    EXPECT_EQ(a.fibre, b.fibre) << smooth;
    EXPECT_LT(a.hairiness, b.hairiness) << smooth;
    EXPECT_LT(a.lobes.fuzz, b.lobes.fuzz) << smooth;
    EXPECT_LT(a.unevenness, b.unevenness) << smooth;
  };
  expect_smoother("Combed cotton", "Cotton");
  expect_smoother("Reeled silk", "Silk");
  expect_smoother("Wool", "Woollen yarn");
  expect_smoother("Polyester filament", "Spun polyester");
  EXPECT_GE(lustre(yarn_preset("Combed cotton")), lustre(yarn_preset("Cotton")));
  EXPECT_GT(lustre(yarn_preset("Reeled silk")), 0.52f) << "brighter than spun";
  EXPECT_LT(yarn_preset("Reeled silk").lobes.across_width, 0.9f * yarn_preset("Silk").lobes.across_width);
  EXPECT_LT(lustre(yarn_preset("Woollen yarn")), 0.4f) << "duller than worsted";
  EXPECT_LT(lustre(yarn_preset("Spun polyester")), 0.3f) << "much duller than filament";
  EXPECT_LT(yarn_preset("Spun polyester").lobes.layers, 0.7f * yarn_preset("Polyester filament").lobes.layers);
  EXPECT_LT(packing_fraction(yarn_preset("Woollen yarn")), packing_fraction(yarn_preset("Wool"))) << "loftier";
}

// Near, and traced, a spun yarn of a filament's fibre is untidy.
TEST(ReadyYarns, CutFilamentWandersAsCottonDoes) {
  const FibreFacts cotton = fibre_facts(yarn_preset("Cotton")), spun = fibre_facts(yarn_preset("Spun polyester")),
                   filament = fibre_facts(yarn_preset("Polyester filament"));
  EXPECT_EQ(spun.disorder, cotton.disorder);
  EXPECT_EQ(spun.migration, cotton.migration);
  EXPECT_LT(filament.disorder, 0.2f);
  EXPECT_EQ(spun.density_g_cm3, filament.density_g_cm3);
  const FibreFacts half = fibre_facts(with_hairiness(yarn_preset("Polyester filament"), 0.16f));
  EXPECT_GT(half.disorder, filament.disorder) << "by degrees";
  EXPECT_LT(half.disorder, spun.disorder);
  for (const Fibre fibre : {Fibre::kSilk, Fibre::kViscose, Fibre::kPolyester})
    EXPECT_EQ(fibre_facts(with_hairiness(ready_yarn(fibre), 0)).disorder, fibre_facts(ready_yarn(fibre)).disorder);
}

std::string row(const Yarn& yarn, const char* count) {
  std::ostringstream text;
  text << "| " << yarn.name << " | " << fibre_name(yarn.fibre) << " | " << count << " | " << yarn.diameter_mm << " | "
       << std::lround(angle_deg(yarn)) << " | " << yarn.hairiness << " | " << yarn.unevenness << " | "
       << std::lround(100 * lustre(yarn)) << " | ";
  return text.str();
}

TEST(ReadyYarns, DocsContainThem) {
  std::ifstream file(WEFTLIGHT_SOURCE_DIR "/docs/yarns.md");
  std::stringstream docs;
  docs << file.rdbuf();
  size_t last = 0;
  for (const Sold& sold : kSold) {
    const std::string wanted = row(yarn_preset(sold.yarn), sold.count);
    const size_t at = docs.str().find(wanted);
    EXPECT_NE(at, std::string::npos) << "docs/yarns.md shall hold\n" << wanted;
    EXPECT_GT(at, last) << sold.yarn << " in its order";
    last = at;
  }
}

}  // namespace
}  // namespace weftlight::design
