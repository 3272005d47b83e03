#pragma once
// The ladder of methods: the choice of the cheapest rung that holds a tolerance at a
// footprint, from measured costs and errors (`weftlight chart` writes them).

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "draft/methods.h"
#include "light/formulas.h"
#include "light/names.h"

namespace weftlight::light {

/// One measured point, over scenes and views.
struct LodPoint {
  Method method = Method::kYarn;
  float yarns_per_pixel = 1;  // > 0
  float cost_ns = 0;          // a shaded pixel
  float filtering_error = 0;  // relative RMSE against the method's own supersampled picture
  float model_error = 0;      // relative RMSE against the ray-traced truth
  int samples = 1;            // a pixel; of rung yarn alone more than one
};
using LodTable = std::vector<LodPoint>;

/// The bands of the model before any measurement.
LodTable default_lod_table();

/// From the text of lod_table.csv or chart.csv (columns by name; others are ignored). Empty, with `problem` set, when a
/// column is missing or a number cannot be read.
LodTable read_lod_table(std::string_view csv, std::string& problem);

/// Larger of both errors, interpolated in the logarithm of the footprint, held beyond the ends.
/// Infinity when the ladder has no point of the method with so many samples.
float expected_error(const LodTable& lod_table, Method method, float yarns_per_pixel, int samples = 1);
float expected_cost(const LodTable& lod_table, Method method, float yarns_per_pixel, int samples = 1);

/// What is asked of a picture.
struct LodDemand {
  float tolerance = 0.15f;                  // relative RMSE
  int samples = formulas::kMaxYarnSamples;  // of rung yarn, at the most
};

struct Choice {
  Method method = Method::kYarn;
  int samples = 1;
};
/// Among yarn (by samples), cell, repeat and cloth the cheapest whose expected error is within the tolerance; if none,
/// the cheapest of those within a tenth of the least error.
Choice choose(const LodTable& lod_table, float yarns_per_pixel, const LodDemand& demand);

/// How a picture is drawn, by the footprint of each pixel.
struct Plan {
  // Where yarn gives way to cell, cell to repeat, repeat to cloth (filter.glsl, lod_weights): rising; the finer rung
  // is kept as long as any coarser footprint still needs it.
  std::array<float, 3> methods{};
  // From where on rung yarn needs each finer lattice (lattice.glsl, lattice_for): rising; the last is unused.
  std::array<float, 8> lattices{};
  int samples = formulas::kMaxYarnSamples;  // at the most
};
Plan plan_of(const LodTable& lod_table, const LodDemand& demand);
/// Samples of rung yarn.
int samples_at(const Plan& plan, float yarns_per_pixel);

/// What `auto` costs a pixel of so many yarns, and how far it is off.
struct Expected {
  float cost_ns = 0, error = 0;
};
Expected expected(const LodTable& lod_table, const Plan& plan, float yarns_per_pixel);

}  // namespace weftlight::light
