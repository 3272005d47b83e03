#pragma once
// Level of detail (LOD): chooses the cheapest shading method that meets a tolerance at a footprint, from measured
// costs and errors (written by `weftlight chart`).

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "design/methods.h"
#include "light/formulas.h"

namespace weftlight::light {

using design::Method;

/// One measured point, merged over scenes and views.
struct LodPoint {
  Method method = Method::kYarn;
  float yarns_per_pixel = 1;  // > 0
  float cost_ns = 0;          // a shaded pixel
  float filtering_error = 0;  // relative RMSE against the method's own supersampled picture
  float model_error = 0;      // relative RMSE against the ray-traced truth
  int samples = 1;            // a pixel; only method yarn takes more than one
};
using LodTable = std::vector<LodPoint>;

/// Default bands, before any measurement.
LodTable default_lod_table();

/// From the text of lod_table.csv or chart.csv (columns by name; others are ignored). An error when a column is
/// missing or a number cannot be read.
base::Result<LodTable> read_lod_table(std::string_view csv);

/// The larger of both errors, interpolated in the logarithm of the footprint and constant beyond the ends. Infinity if
/// the table has no point of the method with that many samples.
float expected_error(const LodTable& lod_table, Method method, float yarns_per_pixel, int samples = 1);
float expected_cost(const LodTable& lod_table, Method method, float yarns_per_pixel, int samples = 1);

/// Requirements on a picture.
struct LodDemand {
  float tolerance = 0.15f;                  // relative RMSE
  int samples = formulas::kMaxYarnSamples;  // upper limit, of method yarn
};

struct Choice {
  Method method = Method::kYarn;
  int samples = 1;
};
/// The cheapest of yarn (by samples), cell, repeat and cloth whose expected error is within the tolerance; if there is
/// none, the cheapest within a tenth of the least error.
Choice choose(const LodTable& lod_table, float yarns_per_pixel, const LodDemand& demand);

/// Method and samples of a picture by the footprint of each pixel.
struct Plan {
  // Footprints at which yarn gives way to cell, cell to repeat, repeat to cloth (filter.glsl, lod_weights): rising.
  // The finer method stays as long as any coarser footprint still needs it.
  std::array<float, 3> methods{};
  // Footprints from which method yarn needs each finer lattice (lattice.glsl, lattice_for): rising; the last is
  // unused.
  std::array<float, 8> lattices{};
  int samples = formulas::kMaxYarnSamples;  // upper limit
};
Plan plan_of(const LodTable& lod_table, const LodDemand& demand);
/// Samples of method yarn at a footprint.
int samples_at(const Plan& plan, float yarns_per_pixel);

/// Expected cost and error of `auto` at a footprint.
struct Expected {
  float cost_ns = 0, error = 0;
};
Expected expected(const LodTable& lod_table, const Plan& plan, float yarns_per_pixel);

}  // namespace weftlight::light
