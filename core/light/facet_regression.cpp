#include "light/facet_regression.h"

#include <algorithm>

namespace weftlight::light {
namespace {

constexpr float kStraight = 1e-4f;  // variance of a facet's moments below which there is nothing to fit
using Matrix = FacetRegression::Matrix;

/// By Gauss and Jordan; the matrix is symmetric and positive.
Matrix inverse_of(Matrix m) {
  Matrix out{};
  for (size_t k = 0; k < kFacetMoments; ++k) out[k][k] = 1;
  for (size_t k = 0; k < kFacetMoments; ++k) {
    const float scale = 1 / m[k][k];
    for (size_t c = 0; c < kFacetMoments; ++c) m[k][c] *= scale, out[k][c] *= scale;
    for (size_t r = 0; r < kFacetMoments; ++r) {
      if (r == k) continue;
      const float f = m[r][k];
      for (size_t c = 0; c < kFacetMoments; ++c) m[r][c] -= f * m[k][c], out[r][c] -= f * out[k][c];
    }
  }
  return out;
}

}  // namespace

void FacetRegression::add(float w, const FacetMoments& facets) {
  weight += w;
  for (size_t r = 0; r < kFacetMoments; ++r) {
    mean[r] += w * facets[r];
    for (size_t c = 0; c < kFacetMoments; ++c) inverse[r][c] += w * facets[r] * facets[c];
  }
}

void FacetRegression::finish() {
  const float scale = 1 / std::max(weight, 1e-9f);
  for (float& m : mean) m *= scale;
  for (size_t r = 0; r < kFacetMoments; ++r) {
    for (size_t c = 0; c < kFacetMoments; ++c) inverse[r][c] = inverse[r][c] * scale - mean[r] * mean[c];
    inverse[r][r] += kStraight;
  }
  inverse = inverse_of(inverse);
}

FacetMoments FacetRegression::rise(float sum, const FacetMoments& products) const {
  FacetMoments out{};
  for (size_t r = 0; r < kFacetMoments; ++r)
    for (size_t c = 0; c < kFacetMoments; ++c) out[r] += inverse[r][c] * (products[c] - mean[c] * sum);
  return out;
}

float FacetRegression::correction(float sum, const FacetMoments& rise, const FacetMoments& whole) const {
  float more = 0;
  for (size_t k = 0; k < kFacetMoments; ++k) more += rise[k] * (whole[k] - mean[k]);
  return sum > 0 ? std::clamp(1 + more / sum, 0.5f, 2.0f) : 1.0f;
}

}  // namespace weftlight::light
