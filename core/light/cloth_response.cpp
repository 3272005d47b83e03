#include "light/cloth_response.h"

#include <algorithm>

#include "light/formulas.h"

namespace weftlight::light {

float density_at(const std::array<float, kSlopeBins>& bins, float slope) {
  const float at = std::clamp(formulas::slope_coord(slope) * kSlopeBins - 0.5f, 0.0f, kSlopeBins - 1.001f);
  const size_t k = static_cast<size_t>(at);
  return bins[k] + (bins[k + 1] - bins[k]) * (at - static_cast<float>(k));
}

float closed_form(const FacetSlopes& slopes, float fraction, const glm::vec3& l, const glm::vec3& v) {
  const formulas::vec2 h = formulas::half_slopes(l, v);
  return fraction * formulas::facet_density({density_at(slopes[0], h.x), density_at(slopes[1], h.y)}, h);
}

}  // namespace weftlight::light
