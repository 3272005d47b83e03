#include "ui/style.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace weftlight::ui {
namespace {

float channel(ImU32 color, int shift) { return static_cast<float>(color >> shift & 0xFF) / 255; }

/// Relative luminance as in WCAG 2, 0..1.
float luminance(ImU32 color) {
  const auto linear = [color](int shift) {
    const float v = channel(color, shift);
    return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
  };
  return 0.2126f * linear(IM_COL32_R_SHIFT) + 0.7152f * linear(IM_COL32_G_SHIFT) + 0.0722f * linear(IM_COL32_B_SHIFT);
}

float contrast(ImU32 a, ImU32 b) {
  const float one = luminance(a) + 0.05f, other = luminance(b) + 0.05f;
  return std::max(one, other) / std::min(one, other);
}

TEST(Style, ANoteIsReadOverAnyPicture) {
  for (const Colors& colors : {light_colors(), dark_colors()})
    for (const ImU32 picture : {IM_COL32_BLACK, IM_COL32_WHITE}) {
      const ImU32 background = note_background(colors);
      const ImU32 seen = blend(picture, background | IM_COL32_A_MASK, channel(background, IM_COL32_A_SHIFT));
      EXPECT_GE(contrast(colors.muted, seen), 4.5f) << std::hex << picture;
      EXPECT_GE(contrast(colors.text, seen), 7.0f) << std::hex << picture;
    }
}

TEST(Style, TheChosenOneIsLighterThanTheOthers) {
  for (const bool dark : {false, true}) {
    Style style;
    style.color = dark ? dark_colors() : light_colors();
    style.dark = dark;
    const ImU32 chosen = chosen_background(style), others = choices_background(style.color);
    EXPECT_GT(luminance(chosen), luminance(others)) << dark;
    EXPECT_GE(contrast(chosen, others), 1.2f) << dark;
    EXPECT_GE(contrast(style.color.text, chosen), 7.0f) << dark;
    EXPECT_GE(contrast(style.color.muted, others), 4.0f) << dark;
  }
}

}  // namespace
}  // namespace weftlight::ui
