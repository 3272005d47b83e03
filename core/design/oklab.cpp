#include "design/oklab.h"

#include <algorithm>
#include <cmath>

#include "design/srgb.h"

namespace weftlight::design {

namespace {

float encoded(float c) { return srgb_encoded(std::clamp(c, 0.0f, 1.0f)); }

float cubed(float x) { return x * x * x; }

}  // namespace

Oklab oklab_of(Rgb color) {
  const float r = srgb_decoded(color.r), g = srgb_decoded(color.g), b = srgb_decoded(color.b);
  const float l = std::cbrt(0.4122214708f * r + 0.5363325363f * g + 0.0514459929f * b);
  const float m = std::cbrt(0.2119034982f * r + 0.6806995451f * g + 0.1073969566f * b);
  const float s = std::cbrt(0.0883024619f * r + 0.2817188376f * g + 0.6299787005f * b);
  return {0.2104542553f * l + 0.7936177850f * m - 0.0040720468f * s,
          1.9779984951f * l - 2.4285922050f * m + 0.4505937099f * s,
          0.0259040371f * l + 0.7827717662f * m - 0.8086757660f * s};
}

Rgb rgb_of(Oklab lab) {
  const float l = cubed(lab.lightness + 0.3963377774f * lab.a + 0.2158037573f * lab.b);
  const float m = cubed(lab.lightness - 0.1055613458f * lab.a - 0.0638541728f * lab.b);
  const float s = cubed(lab.lightness - 0.0894841775f * lab.a - 1.2914855480f * lab.b);
  return {encoded(4.0767416621f * l - 3.3077115913f * m + 0.2309699292f * s),
          encoded(-1.2684380046f * l + 2.6097574011f * m - 0.3413193965f * s),
          encoded(-0.0041960863f * l - 0.7034186147f * m + 1.7076147010f * s)};
}

float color_distance(Rgb a, Rgb b) {
  const Oklab x = oklab_of(a), y = oklab_of(b);
  return std::hypot(x.lightness - y.lightness, x.a - y.a, x.b - y.b);
}

}  // namespace weftlight::design
