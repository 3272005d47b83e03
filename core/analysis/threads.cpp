#include "analysis/threads.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "design/fibre.h"
#include "draft/drawdown.h"

namespace weftlight::analysis {

using design::Yarn, design::tex_of;
using draft::ShedControl, draft::Threads, draft::differences, draft::for_each_bit, draft::lifts, draft::transposed;

namespace {

std::vector<int> marks_of_columns(const BitMatrix& m) {
  std::vector<int> marks(static_cast<size_t>(m.cols()), 0);
  for (int r = 0; r < m.rows(); ++r) for_each_bit(m.row(r), [&](int c) { ++marks[static_cast<size_t>(c)]; });
  return marks;
}

// Changes of face between each row and the next (cyclic), per crossing.
double interlacings_down(const BitMatrix& m) {
  int64_t changes = 0;
  for (int r = 0; r < m.rows(); ++r) changes += differences(m.row(r), m.row((r + 1) % m.rows()));
  const double crossings = static_cast<double>(m.rows()) * m.cols();
  return crossings > 0 ? static_cast<double>(changes) / crossings : 0;
}

double width_mm(const Design& design, const Threads& threads, int thread) {
  const auto t = static_cast<size_t>(thread);
  const Yarn& yarn = design.yarns[static_cast<size_t>(threads.yarn[t])];
  const double thick = threads.thickness_mm[t] >= 0 ? static_cast<double>(threads.thickness_mm[t])
                                                    : static_cast<double>(yarn.diameter_mm);
  return threads.spacing_mm[t] >= 0 ? static_cast<double>(threads.spacing_mm[t]) : thick;
}

double total_mm(const Design& design, const Threads& threads) {
  double sum = 0;
  for (int i = 0; i < threads.size(); ++i) sum += width_mm(design, threads, i);
  return sum;
}

double before_shrinkage_mm(double mm, double shrinkage) { return mm / (1 - std::clamp(shrinkage, 0.0, 0.9)); }

struct Sums {
  int64_t threads = 0;
  double relative_weight = 0;  // sum of (thickness of the thread / of its yarn)^2
};

// Adds the yarn of one system: `times` repeats of its threads, each thread `length_mm` long.
void add_needs(const Design& design, const ClothPlan& plan, System system, double times, double length_mm,
               YarnReport& out) {
  const Threads& threads = design.draft.threads(system);
  std::map<std::pair<int, int>, Sums> by_yarn_and_color;
  for (int i = 0; i < threads.size(); ++i) {
    const auto t = static_cast<size_t>(i);
    Sums& sums = by_yarn_and_color[{threads.yarn[t], threads.color[t]}];
    const double own = static_cast<double>(threads.thickness_mm[t]);
    const double yarn_mm = static_cast<double>(design.yarns[static_cast<size_t>(threads.yarn[t])].diameter_mm);
    const double ratio = own >= 0 && yarn_mm > 0 ? own / yarn_mm : 1;
    ++sums.threads;
    sums.relative_weight += ratio * ratio;
  }
  const size_t begin = out.needs.size();
  for (const auto& [key, sums] : by_yarn_and_color) {
    const auto yarn = static_cast<size_t>(key.first);
    const double per_kg = yarn < plan.price_per_kg.size() ? plan.price_per_kg[yarn] : -1;
    const double tex = static_cast<double>(tex_of(design.yarns[yarn]));
    const double each_m = length_mm / 1000 * times * (1 + std::max(plan.spare, 0.0));
    YarnNeed need{system, key.first, key.second, std::llround(static_cast<double>(sums.threads) * times), 0, 0, -1};
    need.length_m = each_m * static_cast<double>(sums.threads);
    need.weight_g = each_m * sums.relative_weight * tex / 1000;
    if (per_kg >= 0) need.cost = need.weight_g / 1000 * per_kg;
    out.needs.push_back(need);
  }
  std::stable_sort(out.needs.begin() + static_cast<std::ptrdiff_t>(begin), out.needs.end(),
                   [](const YarnNeed& a, const YarnNeed& b) { return a.threads > b.threads; });
}

}  // namespace

LoomUse loom_use(const Draft& draft) {
  LoomUse use;
  const BitMatrix named = lifts(draft);
  use.heddles = marks_of_columns(draft.threading);
  use.lifts = marks_of_columns(named);
  for (int e = 0; e < draft.ends(); ++e) {
    const int heddles = draft.threading.count(e);
    use.unthreaded_ends += heddles == 0;
    use.ends_in_several += heddles > 1;
  }
  for (int p = 0; p < draft.picks(); ++p) use.empty_picks += named.first(p) < 0;
  if (draft.shed_control != ShedControl::kTreadling) return use;
  use.treadle_uses = marks_of_columns(draft.treadling);
  for (int p = 0; p < draft.picks(); ++p)
    use.most_treadles_per_pick = std::max(use.most_treadles_per_pick, draft.treadling.count(p));
  return use;
}

Interlacing interlacing(const BitMatrix& cells) {
  return {interlacings_down(cells), interlacings_down(transposed(cells))};
}

double wraps_per_cm(float diameter_mm) { return diameter_mm > 0 ? 10.0 / static_cast<double>(diameter_mm) : 0; }

double sett_per_cm(double wraps, double interlacings) { return wraps / (1 + std::max(interlacings, 0.0)); }

double firm_sett_per_cm(const BitMatrix& cells, const std::vector<WeaveLayer>& layers, double wraps) {
  double sett = 0;
  for (const WeaveLayer& layer : layers) {
    if (layer.loose()) continue;
    BitMatrix own(static_cast<int>(layer.picks.size()), static_cast<int>(layer.ends.size()));
    for (int p = 0; p < own.rows(); ++p)
      for (int e = 0; e < own.cols(); ++e)
        own.set(p, e, cells.get(layer.picks[static_cast<size_t>(p)], layer.ends[static_cast<size_t>(e)]));
    sett += sett_per_cm(wraps, interlacing(own).weft);
  }
  return sett;
}

YarnReport yarn_report(const Design& design, const ClothPlan& plan) {
  YarnReport out;
  const Draft& d = design.draft;
  const double draft_width = total_mm(design, d.warp), draft_length = total_mm(design, d.weft);
  if (draft_width <= 0 || draft_length <= 0) return out;
  const double width = plan.width_mm > 0 ? plan.width_mm : draft_width;
  const double length = plan.length_mm > 0 ? plan.length_mm : draft_length;
  const double across = width / draft_width, along = length / draft_length;
  out.ends = std::llround(d.ends() * across);
  out.picks = std::llround(d.picks() * along);
  out.ends_per_cm = d.ends() / draft_width * 10;
  out.picks_per_cm = d.picks() / draft_length * 10;
  out.loom_width_mm = before_shrinkage_mm(width, plan.weft_shrinkage);
  const double woven_warp = before_shrinkage_mm(length, plan.warp_shrinkage) * (1 + std::max(plan.warp_take_up, 0.0));
  out.warp_length_mm = woven_warp + std::max(plan.loom_waste_mm, 0.0);
  const double pick_mm = out.loom_width_mm * (1 + std::max(plan.weft_take_up, 0.0));
  add_needs(design, plan, System::kWarp, across, out.warp_length_mm, out);
  add_needs(design, plan, System::kWeft, along, pick_mm, out);
  out.cost = 0;
  double woven_g = 0;
  for (const YarnNeed& need : out.needs) {
    (need.system == System::kWarp ? out.warp_m : out.weft_m) += need.length_m;
    out.weight_g += need.weight_g;
    const double fraction = need.system == System::kWarp ? woven_warp / out.warp_length_mm : 1;
    woven_g += need.weight_g * fraction / (1 + std::max(plan.spare, 0.0));
    out.cost = need.cost < 0 || out.cost < 0 ? -1 : out.cost + need.cost;
  }
  out.g_per_m2 = woven_g / (width * length / 1e6);
  return out;
}

}  // namespace weftlight::analysis
