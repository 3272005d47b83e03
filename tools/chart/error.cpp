#include "chart/error.h"

#include <algorithm>
#include <cmath>

namespace weftlight::chart {
namespace {

using Span = std::span<const glm::vec3>;

double dot(glm::dvec3 a, glm::dvec3 b) { return glm::dot(a, b); }

/// Mean over pixels and channels of a product of two differences.
template <class Left, class Right>
double mean_product(size_t count, const Left& left, const Right& right) {
  double sum = 0;
  for (size_t i = 0; i < count; ++i) sum += dot(left(i), right(i));
  return count ? sum / (3.0 * static_cast<double>(count)) : 0;
}

double ratio_of_roots(double above, double below) { return below > 0 ? std::sqrt(std::max(above, 0.0) / below) : 0; }

}  // namespace

double relative_rmse(Span picture, Span truth) {
  const auto difference = [&](size_t i) { return glm::dvec3(picture[i]) - glm::dvec3(truth[i]); };
  const auto value = [&](size_t i) { return glm::dvec3(truth[i]); };
  return ratio_of_roots(mean_product(truth.size(), difference, difference), mean_product(truth.size(), value, value));
}

double relative_rmse(Span picture, Span half, Span other_half) {
  const auto to_one = [&](size_t i) { return glm::dvec3(picture[i]) - glm::dvec3(half[i]); };
  const auto to_other = [&](size_t i) { return glm::dvec3(picture[i]) - glm::dvec3(other_half[i]); };
  const auto one = [&](size_t i) { return glm::dvec3(half[i]); };
  const auto other = [&](size_t i) { return glm::dvec3(other_half[i]); };
  return ratio_of_roots(mean_product(half.size(), to_one, to_other), mean_product(half.size(), one, other));
}

double noise_of(Span half, Span other_half) { return 0.5 * relative_rmse(half, other_half); }

double mean_value(Span picture) {
  glm::dvec3 sum(0);
  for (const glm::vec3& p : picture) sum += glm::dvec3(p);
  return picture.empty() ? 0 : (sum.x + sum.y + sum.z) / (3.0 * static_cast<double>(picture.size()));
}

double mean_ratio(Span picture, Span truth) {
  const double below = mean_value(truth);
  return below > 0 ? mean_value(picture) / below : 0;
}

double flicker_of(const std::vector<Pixels>& pans) {
  if (pans.empty() || pans.front().empty()) return 0;
  const double count = static_cast<double>(pans.size());
  double variance = 0, mean = 0;
  for (size_t i = 0; i < pans.front().size(); ++i) {
    glm::dvec3 sum(0), squares(0);
    for (const Pixels& pan : pans) sum += glm::dvec3(pan[i]), squares += glm::dvec3(pan[i]) * glm::dvec3(pan[i]);
    const glm::dvec3 spread = squares / count - sum * sum / (count * count);
    variance += std::max(spread.x, 0.0) + std::max(spread.y, 0.0) + std::max(spread.z, 0.0);
    mean += (sum.x + sum.y + sum.z) / count;
  }
  const double channels = 3.0 * static_cast<double>(pans.front().size());
  return mean > 0 ? std::sqrt(variance / channels) / (mean / channels) : 0;
}

Pixels box_average(Span samples, int width, int height, int nx, int ny) {
  const int columns = width / nx, rows = height / ny;
  std::vector<glm::dvec3> sums(static_cast<size_t>(columns) * static_cast<size_t>(rows), glm::dvec3(0));
  for (int y = 0; y < rows * ny; ++y) {
    const size_t row = static_cast<size_t>(y / ny) * static_cast<size_t>(columns);
    for (int x = 0; x < columns * nx; ++x) {
      sums[row + static_cast<size_t>(x / nx)] +=
          glm::dvec3(samples[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)]);
    }
  }
  Pixels means;
  means.reserve(sums.size());
  for (const glm::dvec3& s : sums) means.push_back(glm::vec3(s / static_cast<double>(nx * ny)));
  return means;
}

}  // namespace weftlight::chart
