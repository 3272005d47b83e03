#pragma once
// The two BRDFs of VRST 2003, figure 7.

#include <algorithm>
#include <cmath>
#include <string_view>

#include "light/cloth_brdf.h"

namespace weftlight::light {

using cloth::Linear;

/// "cotton" (equal fractions, wide) and "satin" (long weft floats, narrow); colours as given.
inline ClothBrdf preset_cloth_brdf(std::string_view name, Linear warp, Linear weft) {
  if (name == "satin") return make_cloth_brdf(0.1f, 0.9f, 0.3f, 0.3f, warp, weft);
  return make_cloth_brdf(0.5f, 0.5f, 1.0f, 1.0f, warp, weft);
}

/// g(w), the integral of p (h.w)+, without the table. With h = (cos b sin a, sin b, cos b cos a) about a thread's axis
/// p depends on a alone, and the integral over b is closed.
inline float shadowing_exact(const formulas::Vrst03& p, const glm::vec3& w) {
  constexpr int kSteps = 400;
  const auto of_thread = [&](float sigma, float along, float across) {
    const float reach = std::atan(std::min(5 * sigma, 100.0f));  // beyond, the Gaussian is negligible
    float sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      const float a = reach * (2 * (static_cast<float>(i) + 0.5f) / kSteps - 1), slope = std::tan(a) / sigma,
                  front = along * std::sin(a) + w.z * std::cos(a);
      sum +=
          std::exp(-slope * slope) * (std::abs(across) + (formulas::kPi - std::atan2(std::abs(across), front)) * front);
    }
    return sum * reach / kSteps;
  };
  return p.f_warp * p.c_warp * of_thread(p.sigma_warp, w.y, w.x) +
         p.f_weft * p.c_weft * of_thread(p.sigma_weft, w.x, w.y);
}

}  // namespace weftlight::light
