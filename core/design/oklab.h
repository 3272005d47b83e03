#pragma once
// Colours as the eye orders them: OKLab.
// Based on: B. Ottosson, A perceptual color space for image processing, 2020.

#include "draft/draft.h"

namespace weftlight::design {

using draft::Rgb;

struct Oklab {
  float lightness = 0;  // 0 (black) to 1 (white)
  float a = 0, b = 0;   // green to red, blue to yellow
};
Oklab oklab_of(Rgb color);
/// A colour outside the sRGB gamut is clipped to it.
Rgb rgb_of(Oklab lab);

/// Distance of two colours to the eye; black and white are 1 apart.
float color_distance(Rgb a, Rgb b);

}  // namespace weftlight::design
