#include "collection/colour_names.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace weftlight::collection {

using draft::System;

namespace {

enum Name : size_t { kWhite, kGrey, kBlack, kRed, kOrange, kBrown, kYellow, kGreen, kBlue, kPurple, kPink };

/// Hue in degrees, 0 to 360; saturation and lightness of HSL, 0..1.
struct Hsl {
  float hue = 0, saturation = 0, lightness = 0;
};

Hsl hsl_of(Rgb c) {
  const float high = std::max({c.r, c.g, c.b}), low = std::min({c.r, c.g, c.b}), range = high - low;
  Hsl out{0, 0, (high + low) / 2};
  if (range <= 0) return out;
  out.saturation = range / (1 - std::abs(2 * out.lightness - 1) + 1e-6f);
  const float sixth = high == c.r   ? (c.g - c.b) / range + (c.g < c.b ? 6.0f : 0.0f)
                      : high == c.g ? (c.b - c.r) / range + 2
                                    : (c.r - c.g) / range + 4;
  out.hue = 60 * sixth;
  return out;
}

/// Colours of a hue at which dark ones are brown.
Name warm(const Hsl& c, Name bright) {
  constexpr float kDark = 0.42f, kDull = 0.45f, kDullDark = 0.62f;
  return c.lightness < kDark || (c.saturation < kDull && c.lightness < kDullDark) ? kBrown : bright;
}

}  // namespace

// The limits are set by eye, on the colours of yarn cards.
size_t colour_name_of(Rgb color) {
  const Hsl c =
      hsl_of({std::clamp(color.r, 0.0f, 1.0f), std::clamp(color.g, 0.0f, 1.0f), std::clamp(color.b, 0.0f, 1.0f)});
  const float range = c.saturation * (1 - std::abs(2 * c.lightness - 1));
  if (c.lightness < 0.12f) return kBlack;
  if (c.lightness > 0.92f || (c.lightness > 0.85f && range < 0.15f)) return kWhite;
  if (range < 0.09f) return c.lightness < 0.2f ? kBlack : kGrey;
  const bool pale = c.lightness > 0.68f;
  if (c.hue < 14 || c.hue >= 345) return pale ? kPink : kRed;
  if (c.hue < 44) return warm(c, kOrange);
  if (c.hue < 68) return c.lightness < 0.30f ? kBrown : kYellow;
  if (c.hue < 168) return kGreen;
  if (c.hue < 256) return kBlue;
  if (c.hue < 310) return kPurple;
  return pale || c.lightness > 0.5f ? kPink : c.hue < 325 ? kPurple : kRed;
}

std::optional<size_t> colour_of_id(std::string_view id) {
  for (size_t i = 0; i < kColourNames.size(); ++i)
    if (id == kColourNames[i].id) return i;
  return {};
}

uint32_t colours_of(const Draft& draft) {
  constexpr int kMinShare = 20;  // a thread in so many
  std::array<int64_t, kColourNames.size()> threads{};
  std::vector<size_t> names;
  for (const Rgb& color : draft.palette) names.push_back(colour_name_of(color));
  for (const System system : {System::kWarp, System::kWeft})
    for (const int color : draft.threads(system).color) ++threads[names[static_cast<size_t>(color)]];
  const int64_t all = int64_t{draft.ends()} + draft.picks();
  uint32_t found = 0;
  for (size_t i = 0; i < threads.size(); ++i)
    if (threads[i] > 0 && threads[i] * kMinShare >= all) found |= uint32_t{1} << i;
  return found;
}

}  // namespace weftlight::collection
