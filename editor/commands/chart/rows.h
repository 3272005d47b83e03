#pragma once
// The rows of chart.csv: one measured method on one scene, view and footprint. Text to rows and back,
// which rows stand on the Pareto front, and the ladder that `auto` reads from them.

#include <string>
#include <string_view>
#include <vector>

#include "commands/chart/names.h"
#include "light/lod_table.h"

namespace weftlight::chart {

struct ChartRow {
  std::string scene;
  int view_deg = 0;            // from the normal
  double yarns_per_pixel = 1;  // across the tilt; along it a pixel is longer by 1 / cos(view)
  Method method = Method::kYarn;
  int samples = 1;  // a pixel: of rung yarn those of its lattice; of auto 0, as its tolerance asks
  double ns_per_pixel = 0, instructions_per_pixel = 0;
  double model_error = 0;      // relative RMSE against the traced threads
  double filtering_error = 0;  // relative RMSE against the method's own picture, supersampled
  double energy_ratio = 1;     // mean over the truth's mean
  double flip = 0;             // FLIP against the mean of both halves of the truth (flip.h)
  double flicker = 0;
  double bytes = 0;
  bool on_front = false;

  bool same_place(const ChartRow& other) const;  // scene, view and footprint
  bool same_cell(const ChartRow& other) const;   // and method, and samples
};

/// What of the chart is asked for: rows at one of each; all where none is named.
struct ChartPart {
  std::vector<std::string> scenes;
  std::vector<int> views_deg;
  std::vector<double> yarns_per_pixel;

  bool holds(const ChartRow& row) const;
};

/// Every row that can be measured, by scene, view, footprint, method and samples: the order of the file.
std::vector<ChartRow> chart_cells(const std::vector<Method>& methods);

inline constexpr std::string_view kChartColumns =
    "scene,view_deg,yarns_per_pixel,method,samples,ns_per_pixel,instructions_per_pixel,rel_rmse_model,rel_rmse_"
    "filtering,"
    "flip,energy_ratio,flicker,bytes,on_front";

std::string chart_csv(const std::vector<ChartRow>& rows);
/// Rows that cannot be read are left out; empty when the columns are others.
std::vector<ChartRow> read_chart(std::string_view csv);

/// The row with its numbers as the file shows them, so that what is decided on them can be decided again.
ChartRow as_written(ChartRow row);

/// on_front: no other method at the same place is both cheaper (nanoseconds) and nearer the truth.
void mark_front(std::vector<ChartRow>& rows);

/// Errors (of the worst scene and view) and mean cost of each rung at each footprint. The footprint
/// of the ladder is that of the shaders, the root of the pixel's area, so rows of a tilted view move along.
LodTable lod_table_of(const std::vector<ChartRow>& rows);
/// In the form of presets/lod_table.csv (core/light/lod_table.h, read_lod_table).
std::string lod_table_csv(const LodTable& lod_table);

}  // namespace weftlight::chart
