#include "analysis/measures.h"

#include <algorithm>
#include <cmath>

#include "analysis/reeds.h"
#include "design/fibre.h"

namespace weftlight::analysis {

using design::ClothPlan, design::spacing_of, design::tex_of;

namespace {

double per_cm(const Design& design, System system) {
  const int threads = design.draft.threads(system).size();
  double mm = 0;
  for (int i = 0; i < threads; ++i) mm += spacing_of(design, system, i);
  return mm > 0 ? 10.0 * threads / mm : 0;
}

int64_t whole(double threads) {
  return std::max<int64_t>(1, std::llround(std::min(threads, static_cast<double>(kMaxClothThreads))));
}

/// Finished width over the width in the reed, and finished length over the woven length.
struct Contraction {
  double width, length;
};
Contraction contraction(const ClothPlan& p) {
  return {(1 - static_cast<double>(p.weft_shrinkage)) / (1 + static_cast<double>(p.weft_take_up)),
          1 - static_cast<double>(p.warp_shrinkage)};
}

void measure_across(const ClothPlan& p, int draft_ends, double kept, ClothMeasures& m) {
  m.wanted_ends_per_cm = p.ends_per_cm > 0 ? static_cast<double>(p.ends_per_cm) : m.draft_ends_per_cm * kept;
  m.loom_ends_per_cm = p.reed.dents > 0 ? sett_in_reed(p.reed, p.sleying) : m.wanted_ends_per_cm;
  m.cloth_ends_per_cm = m.loom_ends_per_cm / kept;
  m.ends = p.width_mm > 0 ? whole(static_cast<double>(p.width_mm) / 10 * m.cloth_ends_per_cm) : draft_ends;
  m.reed_width_mm = static_cast<double>(m.ends) / m.loom_ends_per_cm * 10;
  m.woven_width_mm = m.reed_width_mm / (1 + static_cast<double>(p.weft_take_up));
  m.width_mm = m.reed_width_mm * kept;
  m.floating = p.floating_selvedges ? 2 : 0;
  if (p.reed.dents > 0) m.dents = dents_for(m.ends, p.sleying) + m.floating;
}

void measure_along(const ClothPlan& p, int draft_picks, double kept, ClothMeasures& m) {
  m.loom_picks_per_cm = p.picks_per_cm > 0 ? static_cast<double>(p.picks_per_cm) : m.draft_picks_per_cm * kept;
  m.cloth_picks_per_cm = m.loom_picks_per_cm / kept;
  const int64_t picks =
      p.length_mm > 0 ? whole(static_cast<double>(p.length_mm) / 10 * m.cloth_picks_per_cm) : draft_picks;
  m.picks = std::min(picks * p.pieces, kMaxClothThreads);
  m.woven_length_mm = static_cast<double>(picks) / m.loom_picks_per_cm * 10;
  m.length_mm = m.woven_length_mm * kept;
  m.warp_woven_mm = p.pieces * m.woven_length_mm * (1 + static_cast<double>(p.warp_take_up));
  m.warp_length_mm =
      m.warp_woven_mm + p.pieces * static_cast<double>(p.fringe_mm) + static_cast<double>(p.loom_waste_mm);
}

}  // namespace

ClothMeasures cloth_measures(const Design& design) {
  const ClothPlan plan = clamped(design.plan);
  ClothMeasures m;
  m.draft_ends_per_cm = per_cm(design, System::kWarp);
  m.draft_picks_per_cm = per_cm(design, System::kWeft);
  if (m.draft_ends_per_cm <= 0 || m.draft_picks_per_cm <= 0) return {};
  const Contraction kept = contraction(plan);
  measure_across(plan, design.draft.ends(), kept.width, m);
  measure_along(plan, design.draft.picks(), kept.length, m);
  return m;
}

MeanThread mean_thread(const Design& design, System system, std::optional<int> yarn) {
  const draft::Threads& threads = design.draft.threads(system);
  MeanThread mean;
  for (size_t i = 0; i < threads.yarn.size(); ++i) {
    if (yarn && threads.yarn[i] != *yarn) continue;
    const design::Yarn& of = design.yarns[static_cast<size_t>(threads.yarn[i])];
    const float own = threads.thickness_mm[i];
    ++mean.threads;
    const float thickness = own >= 0 ? own : of.diameter_mm;
    mean.diameter_mm += static_cast<double>(thickness);
    mean.spun_mm += design::spun_diameter_mm(of, thickness);
    mean.tex += static_cast<double>(own >= 0 ? tex_of(of, own) : tex_of(of));
  }
  mean.diameter_mm /= std::max(mean.threads, 1);
  mean.tex /= std::max(mean.threads, 1);
  mean.spun_mm /= std::max(mean.threads, 1);
  return mean;
}

}  // namespace weftlight::analysis
