#pragma once
// The plan of the cloth on the command line: options that stand in for what the file plans, and the plan in words and
// as JSON.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/units.h"
#include "design/design.h"

namespace CLI {
class App;
}

namespace weftlight::commands {

using analysis::Units;
using design::Design;

/// What was given; the file's plan has the rest. Fractions, and lengths in mm.
struct PlanOptions {
  std::optional<float> width_mm, length_mm, fringe_mm, loom_waste_mm, bout_mm, raddle_mm;
  std::optional<float> shrinkage, warp_shrinkage, weft_shrinkage, warp_take_up, weft_take_up, spare;
  std::optional<float> ends_per_cm, picks_per_cm;
  std::optional<int> pieces;
  std::string reed, sleying;        // checked forms; empty: the file's
  bool floating_selvedges = false;  // true: in any case
  std::vector<std::string> prices;  // [YARN=]PRICE of a kilogram
  Units units = Units::kMetric;
};
void add_plan_options(CLI::App& verb, PlanOptions& options);
/// Adds --units.
void add_units(CLI::App& verb, Units& units);

/// The design with that plan. A sett and a reed that are both asked for are heeded by the sleying; a reed of the file
/// gives way to the sett. Empty, with a line on stderr, if reed, sleying and sett contradict each other, or if a price
/// is none or names no yarn of the draft.
std::optional<Design> with_options(Design design, const PlanOptions& options);

void print_plan(const Design& design, Units units);
/// Measures, warping, reeds and yarn. In mm, cm, m and g, whatever the units.
void add_plan_json(const Design& design, nlohmann::ordered_json& json);

}  // namespace weftlight::commands
