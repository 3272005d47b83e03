#pragma once
// The rows of chart.csv: one method on one scene, view and footprint. Conversion from and to text, the Pareto front,
// and the LOD table for `auto`.

#include <string>
#include <string_view>
#include <vector>

#include "light/lod_table.h"

namespace weftlight::chart {

using design::Method;
using light::LodTable;

struct ChartRow {
  std::string scene;
  int view_deg = 0;            // from the normal
  double yarns_per_pixel = 1;  // across the tilt; a pixel is longer along it by 1 / cos(view)
  Method method = Method::kYarn;
  int samples = 1;  // per pixel: for yarn those of its lattice; for auto 0, since its tolerance decides
  double ns_per_pixel = 0, instructions_per_pixel = 0;
  double model_error = 0;      // relative RMSE against the traced threads
  double filtering_error = 0;  // relative RMSE against a supersampled picture of the same method
  double energy_ratio = 1;     // mean divided by that of the truth
  double flip = 0;             // FLIP against the mean of both halves of the truth (flip.h)
  double flicker = 0;
  double bytes = 0;
  bool on_front = false;

  bool same_conditions(const ChartRow& other) const;  // scene, view and footprint
  bool same_cell(const ChartRow& other) const;        // and method, and samples
};

/// The requested part of the chart; an empty list selects all.
struct ChartSelection {
  std::vector<std::string> scenes;
  std::vector<int> views_deg;
  std::vector<double> yarns_per_pixel;

  bool holds(const ChartRow& row) const;
};

/// All rows that can be measured, by scene, view, footprint, method and samples, in the order of the file.
std::vector<ChartRow> chart_cells(const std::vector<Method>& methods);

inline constexpr std::string_view kChartColumns =
    "scene,view_deg,yarns_per_pixel,method,samples,ns_per_pixel,instructions_per_pixel,rel_rmse_model,rel_rmse_"
    "filtering,"
    "flip,energy_ratio,flicker,bytes,on_front";

std::string chart_csv(const std::vector<ChartRow>& rows);
/// Skips rows that cannot be read; empty if the columns differ.
std::vector<ChartRow> read_chart(std::string_view csv);

/// The row with its numbers rounded as in the file, so that decisions can be reproduced from the file.
ChartRow as_written(const ChartRow& row);

/// Sets on_front: no other method under the same conditions is both cheaper (nanoseconds) and more accurate.
void mark_pareto_front(std::vector<ChartRow>& rows);

/// Errors (over scenes and views) and mean cost of each method at each footprint. The footprint in the LOD table is
/// that of the shaders, the square root of the pixel's area, so that of a tilted view is larger.
LodTable lod_table_of(const std::vector<ChartRow>& rows);
/// In the format of presets/lod_table.csv (core/light/lod_table.h, read_lod_table).
std::string lod_table_csv(const LodTable& lod_table);

}  // namespace weftlight::chart
