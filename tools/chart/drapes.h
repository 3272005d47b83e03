#pragma once
// The rows of the chart on a drape: two cloths as a curtain, under the key light only, the sky only, and a light from
// behind, against the same mesh with ray-traced threads. Defines the rows, the camera and the file.

#include <array>
#include <string>
#include <vector>

#include "chart/scene.h"
#include "design/design.h"
#include "design/methods.h"

namespace weftlight::chart {

using design::Method, design::Scene;

inline constexpr const char* kChartDrape = "curtain";         // fills the picture, without a body behind it
inline constexpr std::array kDrapedScenes{"plain", "satin"};  // the least and the most glossy
// Yarns per pixel in the middle of the picture: single threads, one side of a fold, several folds.
inline constexpr std::array<double, 3> kDrapeFootprints{0.5, 2, 4};
inline constexpr std::array kDrapeLights{ChartLight::kKey, ChartLight::kSky, ChartLight::kBehind};

struct DrapeRow {
  std::string scene;
  ChartLight light = ChartLight::kKey;
  double yarns_per_pixel = 1;
  Method method = Method::kYarn;
  double ns_per_pixel = 0;  // of cloth: the extra time over a picture without cloth, per shaded pixel
  double model_error = 0;   // relative RMSE against the traced threads, without their noise
  double flip = 0;          // FLIP against the mean of both halves of the truth
  double energy_ratio = 1;  // mean divided by that of the truth
  double truth_noise = 0;   // relative RMSE of that mean
};

/// All rows, by scene, light, footprint and method.
std::vector<DrapeRow> drape_cells(const std::vector<Method>& methods, const ChartEffort& effort);
std::string drapes_csv(const std::vector<DrapeRow>& rows);

/// Drape, lights and camera.
Scene drape_scene(ChartLight light);

}  // namespace weftlight::chart
