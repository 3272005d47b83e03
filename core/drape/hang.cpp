#include "drape/hang.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace weftlight::drape {
namespace {

// Halfway between the drapes' own bending lengths, in proportion.
constexpr double kLimpUpTo_mm = 15, kStiffFrom_mm = 23;
// Of bending, so that the bending length is 0.63 and 1.6 times the medium one's.
constexpr std::array<double, 3> kBending{0.25, 1, 4};
// Silk without twist shears at a touch; raw silk and jammed cotton hold.
constexpr std::array<double, 3> kBias{0.5, 1, 2.5};

double twice_area(Vec3 a, Vec3 b, Vec3 c) {
  return static_cast<double>((b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x));
}

}  // namespace

Hang hang_of(double c) {
  if (!(c > 0)) return Hang::kMedium;
  return c < kLimpUpTo_mm ? Hang::kLimp : c < kStiffFrom_mm ? Hang::kMedium : Hang::kStiff;
}

Fabric in_hang(Fabric fabric, Hang hang) {
  fabric.bending_n_m *= kBending[static_cast<size_t>(hang)];
  fabric.bias_n_per_m *= kBias[static_cast<size_t>(hang)];
  return fabric;
}

std::string drape_file(const std::string& name, Hang hang) {
  if (hang == Hang::kMedium || name == "plane") return name;
  return name + "_" + kHangNames[static_cast<size_t>(hang)];
}

double drape_coefficient(const Mesh& mesh, double support_mm, double flat_area_mm2) {
  // Seen from above on a raster of millimetres times four: what is covered at all.
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
