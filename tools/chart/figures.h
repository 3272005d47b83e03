#pragma once
// The figures of the chart, each with a CSV of its data.

#include <string>
#include <vector>

#include "base/result.h"
#include "chart/chart_rows.h"

namespace weftlight::chart {

/// Radiance divided by that of a white Lambertian, by view angle.
struct Brightness {
  std::string scene, method;  // method "truth": traced
  double view_deg = 0, value = 0;
};
struct TruthNoise {
  std::string scene;
  int view_deg = 0;
  double yarns_per_pixel = 1, noise = 0;
};

/// Writes error_cost, error_footprint, filtering_footprint, albedo and memory (.svg, .png, .csv) and
/// truth_noise.csv into `dir`.
base::Result<void> write_chart_figures(const std::string& dir, const std::string& device,
                                       const std::vector<ChartRow>& rows, const std::vector<Brightness>& brightness,
                                       const std::vector<TruthNoise>& noise);

}  // namespace weftlight::chart
