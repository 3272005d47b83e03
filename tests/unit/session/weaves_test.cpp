// The weaves of a new draft: what is offered is what is made, and the size fits it.

#include "session/weaves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "draft/repeat.h"

namespace weftlight::session {
namespace {

const Weave& named(const std::string& name) {
  for (const Weave& weave : weaves())
    if (name == weave.name) return weave;
  return weaves().front();
}

TEST(Weaves, OnlyEvenSatinsAreOffered) {
  EXPECT_EQ(satin_steps(5), (std::vector<int>{2, 3}));
  EXPECT_EQ(satin_steps(8), (std::vector<int>{3, 5})) << "4 would fall back to the first end after two picks";
  EXPECT_TRUE(satin_steps(6).empty());
  EXPECT_TRUE(satin_steps(4).empty());
  const Weave& satin = named("Satin");
  const std::vector<int> shafts = satin.numbers[0].choices({8, 3, 0});
  EXPECT_EQ(std::count(shafts.begin(), shafts.end(), 6), 0);
  EXPECT_EQ(satin.numbers[1].choices({8, 3, 0}), satin_steps(8));
}

TEST(Weaves, OtherShaftsBringTheStepAlong) {
  const Weave& satin = named("Satin");
  EXPECT_EQ(valid_numbers(satin, {8, 4, 0})[1], 3);
  EXPECT_EQ(valid_numbers(satin, {5, 5, 0})[1], 3);
  EXPECT_EQ(valid_numbers(satin, {6, 3, 0})[0], 5);
  EXPECT_EQ(valid_numbers(satin, {100, 7, 0})[0], 24);
}

TEST(Weaves, WholeRepeatsFitEveryWeave) {
  for (const Weave& weave : weaves()) {
    const auto numbers = first_numbers(weave);
    const ClothSize repeat = repeat_of(weave, numbers);
    EXPECT_GT(repeat.ends, 0) << weave.name;
    EXPECT_GT(repeat.picks, 0) << weave.name;
    const ClothSize size = whole_repeats(repeat, {48, 48});
    const Design design = weave.make(numbers, size);
    const Repeat found = design_repeat(design, drawdown(design.draft));
    EXPECT_EQ(size.ends % found.ends, 0) << weave.name;
    EXPECT_EQ(size.picks % found.picks, 0) << weave.name;
    EXPECT_LE(found.ends, repeat.ends) << weave.name << " does not close at its edge";
    EXPECT_LE(found.picks, repeat.picks) << weave.name << " does not close at its edge";
  }
}

TEST(Weaves, SizesAreWholeRepeatsNearWhatWasAsked) {
  EXPECT_EQ(whole_repeats({14, 8}, {48, 48}).ends, 42);
  EXPECT_EQ(whole_repeats({14, 8}, {50, 3}).ends, 56);
  EXPECT_EQ(whole_repeats({14, 8}, {50, 3}).picks, 8);
  EXPECT_EQ(whole_repeats({0, 0}, {50, 3}).ends, 50);
}

}  // namespace
}  // namespace weftlight::session
