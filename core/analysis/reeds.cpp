#include "analysis/reeds.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace weftlight::analysis {

using design::ends_per_dent;

namespace {

constexpr float kPer10Cm[] = {10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60, 70, 80, 90, 100, 110, 120};
constexpr float kPerInch[] = {4, 5, 6, 8, 10, 12, 15, 16, 18, 20, 24, 30};

/// What a sleying costs the weaver, as a deviation of the sett.
double inconvenience(const std::vector<int>& sleying) {
  const auto [fewest, most] = std::ranges::minmax(sleying);
  return 0.006 * static_cast<double>(sleying.size() - 1) + (fewest == 0 ? 0.012 : 0) + 0.003 * std::max(0, most - 2) +
         0.02 * std::max(0, most - 3);
}

double badness(const SleyedReed& r) { return std::abs(r.deviation) + inconvenience(r.sleying); }

SleyedReed sleyed(const Reed& reed, const std::vector<int>& sleying, double wanted_per_cm) {
  const double sett = sett_in_reed(reed, sleying);
  return {reed, sleying, sett, sett / wanted_per_cm - 1};
}

/// `more` of `dents` dents have an end more than the others; those come last, as charts print them.
std::vector<int> pattern(int ends, int dents, int more) {
  std::vector<int> sleying(static_cast<size_t>(dents), ends);
  std::fill(sleying.end() - more, sleying.end(), ends + 1);
  return sleying;
}

std::vector<std::vector<int>> all_patterns() {
  constexpr int kMaxEnds = 5;
  constexpr int kSteps[][2] = {{4, 1}, {3, 1}, {2, 1}, {3, 2}, {4, 3}};  // dents, those with one more
  std::vector<std::vector<int>> all;
  for (int ends = 0; ends <= kMaxEnds; ++ends) {
    if (ends > 0) all.push_back({ends});
    for (const auto& [dents, more] : kSteps)
      if (ends < kMaxEnds) all.push_back(pattern(ends, dents, more));
  }
  return all;
}

}  // namespace

std::span<const float> standard_reeds(bool per_inch) {
  return per_inch ? std::span<const float>(kPerInch) : std::span<const float>(kPer10Cm);
}

const std::vector<std::vector<int>>& sleying_patterns() {
  static const std::vector<std::vector<int>> all = all_patterns();
  return all;
}

double sett_in_reed(const Reed& reed, const std::vector<int>& sleying) {
  constexpr double kCmOfInch = 2.54;
  return static_cast<double>(reed.dents) / (reed.per_inch ? kCmOfInch : 10) * ends_per_dent(sleying);
}

int64_t dents_for(int64_t ends, const std::vector<int>& sleying) {
  const int64_t together = std::accumulate(sleying.begin(), sleying.end(), int64_t{0});
  if (ends <= 0 || together <= 0) return 0;
  int64_t left = (ends - 1) % together + 1, dents = (ends - 1) / together * static_cast<int64_t>(sleying.size());
  for (size_t i = 0; left > 0; ++i, ++dents) left -= sleying[i];
  return dents;
}

std::vector<int> even_numbers(double mean, int most) {
  int best = 1;
  const auto off = [mean](int n) { return std::abs(std::round(mean * n) / n - mean); };
  for (int n = 2; n <= most; ++n)
    if (off(n) < off(best) - 1e-9) best = n;
  const auto sum = static_cast<int64_t>(std::round(mean * best));
  std::vector<int> numbers;
  for (int i = 0; i < best; ++i) numbers.push_back(static_cast<int>(sum * (i + 1) / best - sum * i / best));
  return numbers;
}

SleyedReed best_sleyed(const Reed& reed, double ends_per_cm) {
  SleyedReed best;
  for (const std::vector<int>& sleying : sleying_patterns()) {
    SleyedReed one = sleyed(reed, sleying, ends_per_cm);
    if (!(std::abs(one.deviation) <= kMaxSettDeviation)) continue;
    if (best.sleying.empty() || badness(one) < badness(best)) best = std::move(one);
  }
  return best;
}

std::vector<SleyedReed> nearest_reeds(double ends_per_cm, bool per_inch, size_t most) {
  std::vector<SleyedReed> all;
  if (!(ends_per_cm > 0)) return all;
  for (const float dents : standard_reeds(per_inch)) {
    SleyedReed best = best_sleyed({dents, per_inch}, ends_per_cm);
    if (!best.sleying.empty()) all.push_back(std::move(best));
  }
  std::ranges::stable_sort(all, {}, badness);
  if (all.size() > most) all.resize(most);
  return all;
}

}  // namespace weftlight::analysis
