#pragma once
// The sRGB curve of shaders/srgb.glsl as C++: srgb_decoded() and srgb_encoded() of a channel of 0..1.

#include <cmath>

namespace weftlight::design {

namespace srgb_formulas {
using std::pow;
#define FORMULA inline
#include "shaders/srgb.glsl"
#undef FORMULA
}  // namespace srgb_formulas

using srgb_formulas::srgb_decoded;
using srgb_formulas::srgb_encoded;

}  // namespace weftlight::design
