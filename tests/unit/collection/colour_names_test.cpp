#include "collection/colour_names.h"

#include <gtest/gtest.h>

#include <string>

namespace weftlight::collection {
namespace {

std::string name(int rgb) {
  const auto part = [rgb](int shift) { return static_cast<float>((rgb >> shift) & 255) / 255; };
  return kColourNames[colour_name_of({part(16), part(8), part(0)})].id;
}

TEST(ColourNames, AreWhatPeopleSay) {
  const std::pair<int, const char*> colours[] = {
      {0xFFFFFF, "white"}, {0xF5F0E6, "white"},  {0x000000, "black"},  {0x1A1A1F, "black"},  {0x808080, "grey"},
      {0xC0C0C0, "grey"},  {0xFF0000, "red"},    {0x8B1A1A, "red"},    {0xFF8C00, "orange"}, {0x8B4513, "brown"},
      {0xA0785A, "brown"}, {0xFFE000, "yellow"}, {0x228B22, "green"},  {0x808000, "brown"},  {0x2F5597, "blue"},
      {0x000080, "blue"},  {0x87CEEB, "blue"},   {0x800080, "purple"}, {0xFFB6C1, "pink"},   {0xFF69B4, "pink"}};
  for (const auto& [rgb, said] : colours) EXPECT_EQ(name(rgb), said) << std::hex << rgb;
}

TEST(ColourNames, EveryColourHasOne) {
  for (int rgb = 0; rgb < 0x1000000; rgb += 0x10305) EXPECT_FALSE(name(rgb).empty());
  EXPECT_LT(colour_name_of({-1, 5, 0.5f}), kColourNames.size());
}

TEST(ColourNames, AFewThreadsDoNotCount) {
  draft::Draft d = draft::blank_draft(60, 40, 4, 4);
  d.palette = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
  for (int& color : d.weft.color) color = 1;
  d.warp.color[0] = 2;
  EXPECT_EQ(colours_of(d), (1u << *colour_of_id("red")) | (1u << *colour_of_id("blue")));
  for (int i = 0; i < 5; ++i) d.warp.color[static_cast<size_t>(i)] = 2;
  EXPECT_NE(colours_of(d) & 1u << *colour_of_id("green"), 0U);
}

}  // namespace
}  // namespace weftlight::collection
