// The table of a yarn's parameters, and that docs/yarns.md agrees with it.

#include "design/yarn_fields.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

#include "paths.h"

namespace weftlight::design {
namespace {

std::string number(float v) {
  std::ostringstream text;
  text << v;
  return text.str();
}

std::string row(const FieldFacts& f, float usual) {
  const std::string unit = *f.unit ? f.unit : "-";
  return std::string("| ") + f.label + " | " + f.key + " | " + unit + " | " + number(usual) + " | " + number(f.low) +
         " to " + number(f.high) + " | " + number(f.from) + " to " + number(f.to) + " | " + f.tip + " | " + f.source +
         " |\n";
}

std::string table() {
  std::string text =
      "| label | key | unit | default | range | slider | what it is | where the figures are from |\n"
      "|---|---|---|---|---|---|---|---|\n";
  const Yarn yarn;
  text += row(kPliesFacts, static_cast<float>(yarn.plies));
  for (const YarnField<Yarn>& f : kYarnFields) text += row(f.facts, yarn.*f.member);
  for (const YarnField<Lobes>& f : kLobeFields) text += row(f.facts, yarn.lobes.*f.member);
  return text;
}

void expect_sound(const FieldFacts& f, float usual, std::set<std::string>& seen) {
  EXPECT_TRUE(f.low <= f.from && f.from < f.to && f.to <= f.high) << f.key;
  EXPECT_TRUE(f.from <= usual && usual <= f.to) << f.key;
  EXPECT_TRUE(seen.insert(f.key).second && seen.insert(f.id).second) << f.key;
  EXPECT_GT(std::string(f.source).size(), 4u) << f.key;
}

TEST(YarnFields, DocsContainTheTable) {
  std::ifstream file(WEFTLIGHT_SOURCE_DIR "/docs/yarns.md");
  std::stringstream docs;
  docs << file.rdbuf();
  EXPECT_NE(docs.str().find(table()), std::string::npos) << "docs/yarns.md shall hold\n" << table();
}

TEST(YarnFields, RangesHoldTheDefaultsAndTheSliders) {
  std::set<std::string> seen;
  const Yarn yarn;
  expect_sound(kPliesFacts, static_cast<float>(yarn.plies), seen);
  for (const YarnField<Yarn>& f : kYarnFields) expect_sound(f.facts, yarn.*f.member, seen);
  for (const YarnField<Lobes>& f : kLobeFields) expect_sound(f.facts, yarn.lobes.*f.member, seen);
}

TEST(YarnFields, AreClampedToTheirRanges) {
  for (const YarnField<Lobes>& f : kLobeFields) {
    for (const float wild : {-1e30f, 1e30f, std::numeric_limits<float>::quiet_NaN()}) {
      Lobes lobes;
      lobes.*f.member = wild;
      const float expected = std::isnan(wild) ? Lobes{}.*f.member : wild < 0 ? f.facts.low : f.facts.high;
      EXPECT_EQ(clamped(lobes).*f.member, expected) << f.facts.key;
    }
  }
}

}  // namespace
}  // namespace weftlight::design
