#include "light/engine_tint.h"

#include <algorithm>

namespace weftlight::light {

namespace {

constexpr float kMostChange = 1.2f, kMostTint = 5;  // logarithms
// Weights, over those of all means, of the squares of the logarithms and of their change: numbers that hardly count
// stay near 0, and no step is too long.
constexpr double kPull = 2e-4, kDamping = 2e-3;

// Numbers: of each channel the logarithm of the base colour and four of the tint; two of the highlight.
constexpr size_t kTerms = 4, kOfChannel = 1 + kTerms, kShine = 3 * kOfChannel, kNumbers = kShine + 2;

/// Normal equations, the right-hand side in the last column.
using Equations = std::array<std::array<double, kNumbers + 1>, kNumbers>;
using Numbers = std::array<double, kNumbers>;

void add(Equations& to, const TintedMean& mean, size_t channel) {
  const int c = static_cast<int>(channel);
  Numbers row{};
  const size_t first = channel * kOfChannel;
  row[first] = static_cast<double>(mean.body[c]);
  for (size_t k = 0; k < kTerms; ++k) row[first + 1 + k] = static_cast<double>(mean.body_by[k][c]);
  for (size_t k = 0; k < 2; ++k) row[kShine + k] = static_cast<double>(mean.gloss_by[k][c]);
  for (size_t i = 0; i < kNumbers; ++i) {
    const double by = static_cast<double>(mean.weight[c]) * row[i];
    if (by == 0) continue;
    for (size_t j = 0; j < kNumbers; ++j) to[i][j] += by * row[j];
    to[i][kNumbers] += by * static_cast<double>(mean.wanted[c] - mean.whole[c]);
  }
}

/// By elimination; numbers that nothing depends on stay as they are.
Numbers solved(Equations a) {
  const auto counts = [&a](size_t i) { return a[i][i] > 1e-12; };
  for (size_t i = 0; i < kNumbers; ++i) {
    for (size_t j = i + 1; counts(i) && j < kNumbers; ++j) {
      const double by = a[j][i] / a[i][i];
      for (size_t k = i; k <= kNumbers; ++k) a[j][k] -= by * a[i][k];
    }
  }
  Numbers x{};
  for (size_t i = kNumbers; i-- > 0;) {
    double rest = a[i][kNumbers];
    for (size_t j = i + 1; j < kNumbers; ++j) rest -= a[i][j] * x[j];
    x[i] = counts(i) ? std::clamp(rest / a[i][i], -double{kMostChange}, double{kMostChange}) : 0;
  }
  return x;
}

}  // namespace

void move_tint(glm::vec3& base, ViewTint& tint, float most_shine, std::span<const TintedMean> means) {
  Equations a{};
  glm::vec3 scale(0);  // of the squares of all means
  for (const TintedMean& mean : means) {
    for (size_t c = 0; c < 3; ++c) add(a, mean, c);
    scale += mean.weight * mean.wanted * mean.wanted;
  }
  std::array<float*, kNumbers> at{};
  for (size_t c = 0; c < 3; ++c) {
    const int channel = static_cast<int>(c);
    const size_t first = c * kOfChannel + 1;
    size_t k = first;
    for (glm::vec3* term : {&tint.weft, &tint.warp, &tint.late_weft, &tint.late_warp}) at[k++] = &(*term)[channel];
    const double body = kDamping * a[first - 1][first - 1];
    for (size_t i = first; i < k; ++i) {
      const double pull = kPull * static_cast<double>(scale[channel]);
      a[i][i] += pull + body, a[i][kNumbers] -= pull * static_cast<double>(*at[i]);
    }
  }
  at[kShine] = &tint.shine.x, at[kShine + 1] = &tint.shine.y;
  for (size_t i = kShine; i < kNumbers; ++i) {
    const double pull = kPull * static_cast<double>(scale.r + scale.g + scale.b);
    a[i][i] += pull, a[i][kNumbers] -= pull * static_cast<double>(*at[i]);
  }
  const Numbers moved = solved(a);
  for (size_t i = 0; i < kNumbers; ++i)
    if (at[i]) *at[i] = std::clamp(*at[i] + static_cast<float>(moved[i]), -kMostTint, kMostTint);
  tint.shine = glm::min(tint.shine, glm::vec2(most_shine));
  for (size_t c = 0; c < 3; ++c) base[static_cast<int>(c)] *= static_cast<float>(std::exp(moved[c * kOfChannel]));
}

}  // namespace weftlight::light
