// The weaves that stand for the colours of a picture.

#include <gtest/gtest.h>

#include "weaves/families.h"

namespace weftlight::weaves {
namespace {

/// One colour after the other, eight ends each.
Pixels steps_of(std::initializer_list<float> greys) {
  Pixels out{8 * static_cast<int>(greys.size()), 16, {}};
  for (int pick = 0; pick < out.height; ++pick)
    for (const float grey : greys)
      for (int end = 0; end < 8; ++end) out.rgb.push_back({grey, grey, grey});
  return out;
}

TEST(WeaveWords, AreReadOrRefusedInWords) {
  EXPECT_EQ(read_weave_words("satin 8/3").value_or(BitMatrix()), shaded_satin(8, 3));
  EXPECT_EQ(read_weave_words("twill 2/1")->rows(), 3);
  EXPECT_NE(*read_weave_words("twill 1/3"), *read_weave_words("twill 1/3 left"));
  EXPECT_EQ(read_weave_words("20-02 02-01-01")->rows(), 4) << "ISO 9354";
  EXPECT_EQ(read_weave_words("auto")->rows(), 0);
  for (const char* words : {"satin 6/2", "satin 8/8", "satin", "twill 0/1", "twill 900/900", "velvet", "plain!"})
    EXPECT_NE(problem_of(read_weave_words(words)).find(words), std::string::npos) << words;
}

TEST(PictureWeaves, AreShadedByLightnessWhereNoneIsChosen) {
  const Pixels picture = steps_of({0, 0.5f, 1});
  const BitMatrix shaded = picture_weave(picture, {3, 7, 8, {}});
  for (int color = 0; color < 3; ++color) {
    int up = 0;
    for (int end = 0; end < 8; ++end) up += shaded.get(3, 8 * color + end) ? 1 : 0;
    EXPECT_EQ(up, 7 - 3 * color) << "the darkest is the most warp-faced";
  }
  EXPECT_EQ(picture_weave(picture, {3, 7, 8, {BitMatrix(), shaded_satin(8, 4)}}), shaded) << "the same, chosen";
}

TEST(PictureWeaves, AreTheOnesThatWereChosen) {
  const BitMatrix cells =
      picture_weave(steps_of({0, 1}), {2, 7, 8, {*read_weave_words("twill 2/2"), *read_weave_words("plain")}});
  for (int pick = 0; pick < 15; ++pick)
    for (int end = 8; end < 15; ++end) EXPECT_NE(cells.get(pick, end), cells.get(pick, end + 1));
  EXPECT_EQ(cells.get(4, 1), cells.get(8, 5));
  // Floats are bounded over the edges of the regions, too.
  EXPECT_EQ(picture_weave(steps_of({0, 1}), {2, 1, 8, {}}), picture_weave(steps_of({0.3f, 1}), {2, 1, 8, {}}));
}

}  // namespace
}  // namespace weftlight::weaves
