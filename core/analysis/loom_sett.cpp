#include "analysis/loom_sett.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/measures.h"
#include "analysis/threads.h"
#include "design/edits.h"
#include "draft/drawdown.h"

namespace weftlight::analysis {

using design::with_sett;
using draft::drawdown, draft::transposed;

namespace {

constexpr int kMostThreads = 1024;

double per_unit(Units units) { return units == Units::kImperial ? kInch_mm / 10 : 1; }

int whole(double per_cm, double otherwise, Units units) {
  const double sett = (per_cm > 0 ? per_cm : otherwise) * per_unit(units);
  return static_cast<int>(
      std::lround(std::clamp(sett, 1.0, static_cast<double>(design::kMaxSettPerCm) * per_unit(units))));
}

double wraps(const Design& design, System system) {
  return wraps_per_cm(static_cast<float>(mean_thread(design, system).spun_mm));
}

}  // namespace

LoomSett firm_sett(const Design& design, Units units) {
  BitMatrix cells = drawdown(design.draft);
  cells.resize(std::min(cells.rows(), kMostThreads), std::min(cells.cols(), kMostThreads));
  std::vector<WeaveLayer> layers = weave_layers(cells);
  const double ends = firm_sett_per_cm(cells, layers, wraps(design, System::kWarp));
  for (WeaveLayer& layer : layers) std::swap(layer.ends, layer.picks);
  const double picks = firm_sett_per_cm(transposed(cells), layers, wraps(design, System::kWeft));
  const ClothMeasures m = cloth_measures(design);
  return {whole(ends, m.loom_ends_per_cm, units), whole(picks, m.loom_picks_per_cm, units)};
}

Design with_loom_sett(Design design, LoomSett sett, Units units) {
  const ClothMeasures m = cloth_measures(design);
  if (m.loom_ends_per_cm <= 0 || m.loom_picks_per_cm <= 0) return design;
  const double ends = sett.ends * m.cloth_ends_per_cm / m.loom_ends_per_cm,
               picks = sett.picks * m.cloth_picks_per_cm / m.loom_picks_per_cm;
  design = with_sett(std::move(design), System::kWarp, ends / per_unit(units));
  return with_sett(std::move(design), System::kWeft, picks / per_unit(units));
}

}  // namespace weftlight::analysis
