#include "analysis/yarn_need.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/warping.h"
#include "design/fibre.h"

namespace weftlight::analysis {

using design::ClothPlan, design::YarnPurchase, design::purchase_of, design::tex_of;
using draft::Threads;

namespace {

struct Sums {
  int64_t threads = 0;
  double relative_weight = 0;  // sum of (thickness of the thread / of its yarn)^2
};
using YarnAndColor = std::pair<int, int>;
using SumsOf = std::map<YarnAndColor, Sums>;

void add_thread(const Design& design, const Threads& threads, int thread, int64_t times, SumsOf& sums_of) {
  const auto t = static_cast<size_t>(thread);
  const double own = static_cast<double>(threads.thickness_mm[t]);
  const double yarn_mm = static_cast<double>(design.yarns[static_cast<size_t>(threads.yarn[t])].diameter_mm);
  const double ratio = own >= 0 && yarn_mm > 0 ? own / yarn_mm : 1;
  Sums& sums = sums_of[{threads.yarn[t], threads.color[t]}];
  sums.threads += times;
  sums.relative_weight += static_cast<double>(times) * ratio * ratio;
}

/// The threads of the repeated draft, and the floating selvedges.
SumsOf sums_of(const Design& design, System system, const ClothMeasures& m) {
  const Threads& threads = design.draft.threads(system);
  const int64_t count = m.threads(system), whole = count / threads.size(), more = count % threads.size();
  SumsOf sums;
  for (int i = 0; i < threads.size(); ++i)
    if (const int64_t times = whole + (i < more); times > 0) add_thread(design, threads, i, times, sums);
  if (system == System::kWarp && m.floating > 0) {
    add_thread(design, threads, 0, 1, sums);
    add_thread(design, threads, last_end_of(design.draft, m.ends), 1, sums);
  }
  return sums;
}

void add_needs(const Design& design, System system, const ClothMeasures& m, YarnReport& out) {
  const double spare = 1 + static_cast<double>(clamped(design.plan).spare);
  const double each_m = (system == System::kWarp ? m.warp_length_mm : m.reed_width_mm) / 1000 * spare;
  std::vector<YarnNeed> needs;
  for (const auto& [key, sums] : sums_of(design, system, m)) {
    const double tex = static_cast<double>(tex_of(design.yarns[static_cast<size_t>(key.first)]));
    const auto count = static_cast<double>(sums.threads);
    needs.push_back({system, key.first, key.second, sums.threads, each_m * count,
                     each_m * sums.relative_weight * tex / 1000, sums.relative_weight / count * tex});
  }
  std::ranges::stable_sort(needs, std::greater(), &YarnNeed::threads);
  out.needs.insert(out.needs.end(), needs.begin(), needs.end());
}

void price(const YarnPurchase& bought, YarnToBuy& one) {
  const auto cone_m = static_cast<double>(bought.cone_m), cone_g = static_cast<double>(bought.cone_g);
  double units = one.weight_g / 1000;
  if (cone_m > 0 || cone_g > 0) {
    units = std::ceil(std::min(cone_m > 0 ? one.length_m / cone_m : one.weight_g / cone_g, 1e12) - 1e-9);
    one.cones = static_cast<int64_t>(units);
  }
  if (bought.price > 0) one.cost = units * static_cast<double>(bought.price);
}

void add_purchases(const Design& design, YarnReport& out) {
  std::map<YarnAndColor, YarnToBuy> by_yarn_and_color;
  for (const YarnNeed& need : out.needs) {
    YarnToBuy& one = by_yarn_and_color[{need.yarn, need.color}];
    one.yarn = need.yarn, one.color = need.color;
    one.length_m += need.length_m;
    one.weight_g += need.weight_g;
  }
  out.cost = 0;
  for (auto& [key, one] : by_yarn_and_color) {
    price(purchase_of(design.plan, design.yarns[static_cast<size_t>(one.yarn)].name), one);
    out.cost = one.cost < 0 || out.cost < 0 ? -1 : out.cost + one.cost;
    out.buy.push_back(one);
  }
  std::ranges::stable_sort(out.buy, std::greater(), &YarnToBuy::weight_g);
}

}  // namespace

YarnReport yarn_report(const Design& design, const ClothMeasures& m) {
  YarnReport out;
  if (m.ends == 0 || m.picks == 0) return out;
  add_needs(design, System::kWarp, m, out);
  add_needs(design, System::kWeft, m, out);
  add_purchases(design, out);
  const ClothPlan plan = clamped(design.plan);
  double woven_g = 0;
  for (const YarnNeed& need : out.needs) {
    (need.system == System::kWarp ? out.warp_m : out.weft_m) += need.length_m;
    out.weight_g += need.weight_g;
    const double woven = need.system == System::kWarp ? m.warp_woven_mm / m.warp_length_mm : 1;
    woven_g += need.weight_g * woven / (1 + static_cast<double>(plan.spare));
  }
  out.g_per_m2 = woven_g / (m.width_mm * m.length_mm * plan.pieces / 1e6);
  return out;
}

YarnReport yarn_report(const Design& design) { return yarn_report(design, cloth_measures(design)); }

}  // namespace weftlight::analysis
