#pragma once
// The chart's rows on a drape: two of its cloths as a curtain, in the key light alone, under the sky alone and lit from
// behind, against the same mesh with its threads ray traced. Which rows there are, where the camera stands, the file.

#include <array>
#include <string>
#include <vector>

#include "commands/chart/names.h"
#include "commands/chart/scene.h"
#include "draft/design.h"
#include "draft/methods.h"

namespace weftlight::chart {

inline constexpr const char* kChartDrape = "curtain";         // fills the picture, and nothing stands behind it
inline constexpr std::array kDrapedScenes{"plain", "satin"};  // the dullest and the shiniest
// Yarns a pixel in the middle of the picture: threads, a rise of a fold, folds beside one another.
inline constexpr std::array<double, 3> kDrapeFootprints{0.5, 2, 4};
inline constexpr std::array kDrapeLights{ChartLight::kKey, ChartLight::kSky, ChartLight::kBehind};

struct DrapeRow {
  std::string scene;
  ChartLight light = ChartLight::kKey;
  double yarns_per_pixel = 1;
  Method method = Method::kYarn;
  double ns_per_pixel = 0;  // of cloth; what a picture takes longer than one without it, over the pixels shaded
  double model_error = 0;   // relative RMSE against the traced threads, free of their noise
  double flip = 0;          // FLIP against the mean of both halves of the truth
  double energy_ratio = 1;  // mean over the truth's mean
  double truth_noise = 0;   // relative RMSE of that mean
};

/// Every row there is, by scene, light, footprint and method.
std::vector<DrapeRow> drape_cells(const std::vector<Method>& methods, const ChartEffort& effort);
std::string drapes_csv(const std::vector<DrapeRow>& rows);

/// What hangs, how it is lit and from where it is seen.
Scene drape_scene(ChartLight light);

}  // namespace weftlight::chart
