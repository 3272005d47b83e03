#include "chart/flip.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace weftlight::chart {
namespace {

using glm::dvec2;
using glm::dvec3;
constexpr double kPi = std::numbers::pi;

struct Channels {
  int width, height;
  std::vector<dvec3> at;
  const dvec3& clamped(int x, int y) const {  // coordinates beyond the border are clamped
    x = std::clamp(x, 0, width - 1), y = std::clamp(y, 0, height - 1);
    return at[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
  }
};

// sRGB's primaries under D65.
const glm::dmat3 kXyzOfRgb(0.4124564, 0.2126729, 0.0193339, 0.3575761, 0.7151522, 0.1191920, 0.1804375, 0.0721750,
                           0.9503041);
const dvec3 kWhite = kXyzOfRgb * dvec3(1);

/// Opponent colours: lightness, red to green, blue to yellow.
dvec3 opponents(const dvec3& rgb) {
  const dvec3 t = kXyzOfRgb * rgb / kWhite;
  return {116 * t.y - 16, 500 * (t.x - t.y), 200 * (t.y - t.z)};
}

dvec3 rgb_of_opponents(const dvec3& c) {
  const double y = (c.x + 16) / 116;
  return glm::inverse(kXyzOfRgb) * (dvec3(y + c.y / 500, y, y - c.z / 200) * kWhite);
}

/// CIELAB with the Hunt adjustment: less chroma at low lightness.
dvec3 lab(const dvec3& rgb) {
  const dvec3 t = kXyzOfRgb * rgb / kWhite;
  const auto root = [](double v) {
    constexpr double d = 6.0 / 29;
    return v > d * d * d ? std::cbrt(v) : v / (3 * d * d) + 4.0 / 29;
  };
  const dvec3 f(root(t.x), root(t.y), root(t.z));
  const double l = 116 * f.y - 16;
  return {l, 0.01 * l * 500 * (f.x - f.y), 0.01 * l * 200 * (f.y - f.z)};
}

double distance(const dvec3& a, const dvec3& b) {
  return std::abs(a.x - b.x) + glm::length(dvec2(a.y - b.y, a.z - b.z));
}

/// Filters each opponent channel by its contrast sensitivity function, as sums of Gaussians over degrees.
Channels csf_filtered(const Channels& in, double ppd) {
  constexpr double kMaxWidth = 0.04;
  const auto gauss = [](double a, double b, double d2) {
    return a * std::sqrt(kPi / b) * std::exp(-kPi * kPi * d2 / b);
  };
  const int r = static_cast<int>(std::ceil(3 * std::sqrt(kMaxWidth / (2 * kPi * kPi)) * ppd));
  std::vector<dvec3> weight;
  dvec3 sum(0);
  for (int y = -r; y <= r; ++y) {
    for (int x = -r; x <= r; ++x) {
      const double d2 = (x * x + y * y) / (ppd * ppd);
      weight.push_back({gauss(1, 0.0047, d2), gauss(1, 0.0053, d2), gauss(34.1, 0.04, d2) + gauss(13.5, 0.025, d2)});
      sum += weight.back();
    }
  }
  Channels out{in.width, in.height, {}};
  for (int y = 0; y < in.height; ++y) {
    for (int x = 0; x < in.width; ++x) {
      dvec3 filtered(0);
      size_t k = 0;
      for (int j = -r; j <= r; ++j)
        for (int i = -r; i <= r; ++i) filtered += weight[k++] * in.clamped(x + i, y + j);
      out.at.push_back(lab(glm::clamp(rgb_of_opponents(filtered / sum), 0.0, 1.0)));
    }
  }
  return out;
}

struct Detector {
  int radius;
  std::vector<double> blur, slope, bend;  // along one side; slope and bend: positive and negative parts each sum to 1
};

Detector detector(double ppd) {
  const double sd = 0.5 * 0.082 * ppd;
  Detector d{static_cast<int>(std::ceil(3 * sd)), {}, {}, {}};
  for (int x = -d.radius; x <= d.radius; ++x) {
    const double g = std::exp(-(x * x) / (2 * sd * sd));
    d.blur.push_back(g), d.slope.push_back(-x * g), d.bend.push_back((x * x / (sd * sd) - 1) * g);
  }
  double all = 0;
  for (const double g : d.blur) all += g;
  for (double& g : d.blur) g /= all;
  for (std::vector<double>* side : {&d.slope, &d.bend}) {
    double up = 0, down = 0;
    for (const double g : *side) (g > 0 ? up : down) += std::abs(g);
    for (double& g : *side) g /= g > 0 ? up : down;
  }
  return d;
}

/// Strength of edges and of points at a pixel; the lightness 0..1 in y of `in`.
dvec2 features(const Channels& in, const Detector& d, int x, int y) {
  dvec2 edge(0), point(0);
  for (int j = -d.radius; j <= d.radius; ++j) {
    const size_t row = static_cast<size_t>(j + d.radius);
    dvec3 sums(0);  // blur, slope, bend along x
    for (int i = -d.radius; i <= d.radius; ++i) {
      const size_t k = static_cast<size_t>(i + d.radius);
      sums += in.clamped(x + i, y + j).x * dvec3(d.blur[k], d.slope[k], d.bend[k]);
    }
    edge += dvec2(sums.y * d.blur[row], sums.x * d.slope[row]);
    point += dvec2(sums.z * d.blur[row], sums.x * d.bend[row]);
  }
  return {glm::length(edge), glm::length(point)};
}

}  // namespace

double flip_error(std::span<const glm::vec3> picture, std::span<const glm::vec3> truth, int width, int height,
                  double pixels_per_degree) {
  constexpr double kColourPower = 0.7, kFeaturePower = 0.5, kKnee = 0.4, kAtKnee = 0.95;
  const auto plane = [&](std::span<const glm::vec3> in) {
    Channels p{width, height, {}};
    for (const glm::vec3& v : in) p.at.push_back(opponents(glm::clamp(dvec3(v), 0.0, 1.0)));
    return p;
  };
  Channels a = plane(picture), b = plane(truth);
  const Channels seen_a = csf_filtered(a, pixels_per_degree), seen_b = csf_filtered(b, pixels_per_degree);
  for (Channels* p : {&a, &b})
    for (dvec3& v : p->at) v.x = (v.x + 16) / 116;
  const Detector d = detector(pixels_per_degree);
  const double most = std::pow(distance(lab({0, 1, 0}), lab({0, 0, 1})), kColourPower), knee = kKnee * most;
  double sum = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double far = std::pow(distance(seen_a.clamped(x, y), seen_b.clamped(x, y)), kColourPower);
      const double colour = far < knee ? kAtKnee / knee * far : kAtKnee + (far - knee) / (most - knee) * (1 - kAtKnee);
      const dvec2 apart = glm::abs(features(a, d, x, y) - features(b, d, x, y));
      const double feature = std::pow(std::max(apart.x, apart.y) / std::numbers::sqrt2, kFeaturePower);
      sum += std::pow(colour, 1 - feature);
    }
  }
  return sum / (static_cast<double>(width) * height);
}

}  // namespace weftlight::chart
