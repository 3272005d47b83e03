#pragma once
// The rows of the chart against its second truth: the same patches with every fibre traced, near enough to see it.

#include <array>
#include <string>
#include <vector>

#include "chart/scene.h"
#include "design/methods.h"

namespace weftlight::chart {

using design::Method;

inline constexpr std::array<int, 2> kFibreViews{0, 60};                                      // degrees from the normal
inline constexpr std::array<double, 4> kFibreFootprints{1.0 / 64, 1.0 / 16, 1.0 / 8, 0.25};  // yarns per pixel

/// A method that is compared, with its samples per pixel (for auto 0: its tolerance decides).
struct NearMethod {
  Method method = Method::kYarn;
  int samples = 1;
};
/// Those that draw threads or crossings, and flat colour beside them.
std::vector<NearMethod> near_methods();

struct FibreRow {
  std::string scene;
  int view_deg = 0;
  double yarns_per_pixel = 1;
  std::string method;       // "tubes": the first truth
  int samples = 0;          // per pixel; 0: traced, or auto
  double fibre_error = 0;   // relative RMSE against the fibres, without their noise
  double tube_error = 0;    // the same against the tubes
  double fibre_flip = 0;    // FLIP against the mean of both halves of the fibres
  double energy_ratio = 1;  // mean divided by that of the fibres
};

std::string fibres_csv(const std::vector<FibreRow>& rows);

}  // namespace weftlight::chart
