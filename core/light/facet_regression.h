#pragma once
// Weighted least squares of a quantity on the moments of the local facets.

#include <array>

#include "light/thread_samples.h"

namespace weftlight::light {

inline constexpr float kMaxGradient = 100.0f;  // relative change with a moment

struct FacetRegression {
  using Matrix = std::array<FacetMoments, kFacetMoments>;
  float weight = 0;
  FacetMoments mean{};
  Matrix inverse{};  // of the covariance

  void add(float weight_of, const FacetMoments& facets);
  /// Call after the last add().
  void finish();
  /// Gradient of a quantity by the moments, from its sum over the samples and the sums of its products.
  FacetMoments rise(float sum, const FacetMoments& products) const;
  /// Factor by which the quantity is larger over the whole cloth, whose moments are known, than over the samples.
  float correction(float sum, const FacetMoments& rise, const FacetMoments& whole) const;
};

}  // namespace weftlight::light
