#pragma once
// Least squares of what places show on the moments of their facets, each place with its weight.

#include <array>

#include "light/names.h"
#include "light/thread_samples.h"

namespace weftlight::light {

inline constexpr float kSteepestLean = 100.0f;  // rise with a moment, over the mean

struct FacetRegression {
  using Matrix = std::array<FacetMoments, kFacetMoments>;
  float weight = 0;
  FacetMoments mean{};
  Matrix inverse{};  // of the covariance

  void add(float weight_of, const FacetMoments& facets);
  /// When all are there.
  void finish();
  /// Rise of a quantity with each moment, from its sum over the places and the sums of its products.
  FacetMoments rise(float sum, const FacetMoments& products) const;
  /// Share by which the quantity is larger over the whole cloth, whose moments are known, than over the places.
  float correction(float sum, const FacetMoments& rise, const FacetMoments& whole) const;
};

}  // namespace weftlight::light
