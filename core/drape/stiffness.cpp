#include "drape/stiffness.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace weftlight::drape {
namespace {

// Geometric means of the bending lengths of the three versions.
constexpr double kLimpUpTo_mm = 15, kStiffFrom_mm = 23;
// Factors on the bending stiffness; the bending length is 0.63 and 1.6 times the medium one.
constexpr std::array<double, 3> kBending{0.25, 1, 4};
// Factors on the shear stiffness: untwisted silk shears easily, raw silk and jammed cotton do not.
constexpr std::array<double, 3> kBias{0.5, 1, 2.5};

constexpr double kGravity = 9.81;
// Shear stiffness between the three versions, as a power of the bending length.
constexpr double kBiasPower = 1.75, kMediumLength_mm = 19;
constexpr double kUsualThickness_mm = 0.5;  // thickness for which the gaps of the drapes are set
constexpr double kShortest_mm = 6, kLongest_mm = 60, kThickest_mm = 4;
constexpr int kCacheVersion = 3;  // a new version makes cached meshes invalid

double twice_area(Vec3 a, Vec3 b, Vec3 c) {
  return static_cast<double>((b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x));
}

}  // namespace

DrapeStiffness drape_stiffness_of(double c) {
  if (!(c > 0)) return DrapeStiffness::kMedium;
  return c < kLimpUpTo_mm    ? DrapeStiffness::kLimp
         : c < kStiffFrom_mm ? DrapeStiffness::kMedium
                             : DrapeStiffness::kStiff;
}

Fabric with_stiffness(Fabric fabric, DrapeStiffness stiffness) {
  fabric.bending_n_m *= kBending[static_cast<size_t>(stiffness)];
  fabric.bias_n_per_m *= kBias[static_cast<size_t>(stiffness)];
  return fabric;
}

DrapeParameters drape_parameters(double bending_length_mm, double thickness_mm) {
  const double c = std::clamp(bending_length_mm > 0 ? bending_length_mm : kMediumLength_mm, kShortest_mm, kLongest_mm);
  const double thickness = std::clamp(thickness_mm > 0 ? thickness_mm : kUsualThickness_mm, 0.05, kThickest_mm);
  return {static_cast<int>(std::lround(2 * c)), 5 * static_cast<int>(std::lround(20 * thickness))};
}

std::string drape_file(const std::string& name, const DrapeParameters& parameters) {
  char figures[48];
  std::snprintf(figures, sizeof figures, "_%.1fmm_%.2fmm_v%d", parameters.bending_half_mm / 2.0,
                parameters.thickness_10um / 100.0, kCacheVersion);
  return name + figures;
}

void apply_parameters(Fabric& fabric, Fall& fall, const DrapeParameters& parameters) {
  const double c = parameters.bending_half_mm / 2.0, extra_mm = parameters.thickness_10um / 100.0 - kUsualThickness_mm;
  // Peirce: c^3 = B / (w g). The weight stays that of the drape's fabric, for which threads and drag are tuned.
  fabric.bending_n_m = fabric.kg_per_m2 * kGravity * std::pow(c / 1000, 3);
  fabric.bias_n_per_m *= std::pow(c / kMediumLength_mm, kBiasPower);
  fall.body_gap_mm += extra_mm / 2;
  fall.cloth_gap_mm += extra_mm;
}

std::string drape_file(const std::string& name, DrapeStiffness stiffness) {
  if (stiffness == DrapeStiffness::kMedium || name == "plane") return name;
  return name + "_" + kDrapeStiffnessNames[static_cast<size_t>(stiffness)];
}

double drape_coefficient(const Mesh& mesh, double support_mm, double flat_area_mm2) {
  // Rasterised from above in cells of 4 mm.
  constexpr double kCell_mm = 4;
  if (mesh.position_mm.empty()) return 0;
  Vec3 low = mesh.position_mm[0], high = low;
  for (const Vec3& p : mesh.position_mm) low = glm::min(low, p), high = glm::max(high, p);
  const int columns = static_cast<int>(static_cast<double>(high.x - low.x) / kCell_mm) + 2,
            rows = static_cast<int>(static_cast<double>(high.z - low.z) / kCell_mm) + 2;
  std::vector<bool> covered(static_cast<size_t>(columns) * static_cast<size_t>(rows));
  const auto cell_of = [&](float v, float from) { return static_cast<double>(v - from) / kCell_mm; };
  for (size_t t = 0; t + 2 < mesh.index.size(); t += 3) {
    const Vec3 a = mesh.position_mm[mesh.index[t]], b = mesh.position_mm[mesh.index[t + 1]],
               c = mesh.position_mm[mesh.index[t + 2]];
    const double whole = twice_area(a, b, c);
    if (std::abs(whole) < 1e-9) continue;
    const Vec3 least = glm::min(a, glm::min(b, c)), most = glm::max(a, glm::max(b, c));
    for (int y = static_cast<int>(cell_of(least.z, low.z)); y <= static_cast<int>(cell_of(most.z, low.z)); ++y) {
      for (int x = static_cast<int>(cell_of(least.x, low.x)); x <= static_cast<int>(cell_of(most.x, low.x)); ++x) {
        const Vec3 p{low.x + (static_cast<float>(x) + 0.5f) * static_cast<float>(kCell_mm), 0,
                     low.z + (static_cast<float>(y) + 0.5f) * static_cast<float>(kCell_mm)};
        const double u = twice_area(p, b, c) / whole, v = twice_area(a, p, c) / whole;
        if (u >= 0 && v >= 0 && u + v <= 1)
          covered[static_cast<size_t>(y) * static_cast<size_t>(columns) + static_cast<size_t>(x)] = true;
      }
    }
  }
  const double seen = kCell_mm * kCell_mm * static_cast<double>(std::count(covered.begin(), covered.end(), true));
  const double support = std::numbers::pi * support_mm * support_mm;
  return std::clamp((seen - support) / (flat_area_mm2 - support), 0.0, 1.0);
}

}  // namespace weftlight::drape
