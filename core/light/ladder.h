#pragma once
// The ladder of methods: the choice of the cheapest rung that holds a tolerance at a
// footprint, from measured costs and errors (`weftlight chart` writes them).

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "draft/methods.h"
#include "light/names.h"

namespace weftlight::light {

/// One measured point, over scenes and views.
struct LadderPoint {
  Method method = Method::kYarn;
  float yarns_per_pixel = 1;  // > 0
  float cost_ns = 0;          // a shaded pixel
  float filtering_error = 0;  // relative RMSE against the method's own supersampled picture
  float model_error = 0;      // relative RMSE against the ray-traced truth
};
using Ladder = std::vector<LadderPoint>;

/// The bands of the model before any measurement.
Ladder default_ladder();

/// From the text of chart.csv (columns by name; others are ignored). Empty, with `problem` set, when a
/// column is missing or a number cannot be read.
Ladder read_ladder(std::string_view csv, std::string& problem);

/// Larger of both errors, interpolated in the logarithm of the footprint, held beyond the ends.
/// Infinity when the ladder has no point of the method.
float expected_error(const Ladder& ladder, Method method, float yarns_per_pixel);
float expected_cost(const Ladder& ladder, Method method, float yarns_per_pixel);

/// Among yarn, cell, repeat and cloth the cheapest whose expected error is within the tolerance; if none,
/// the cheapest of those within a tenth of the least error.
Method choose_rung(const Ladder& ladder, float yarns_per_pixel, float tolerance);

/// Footprints where yarn gives way to cell, cell to repeat, repeat to cloth (filter.glsl, rung_weights):
/// rising; the finer rung is kept as long as any coarser footprint still needs it.
std::array<float, 3> rung_edges(const Ladder& ladder, float tolerance);

}  // namespace weftlight::light
