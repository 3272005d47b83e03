// Floating selvedges. Based on: M. Petrini, To Float or not to Float, blog 112, 2023: an edge end is caught when it
// changes its face between the two picks that turn around it, so the direction of the first pick decides.

#include "analysis/warping.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "analysis/reeds.h"

namespace weftlight::analysis {

using draft::Threads, draft::for_each_bit;

namespace {

bool same(const Threads& t, int a, int b) {
  const auto i = static_cast<size_t>(a), k = static_cast<size_t>(b);
  return t.color[i] == t.color[k] && t.yarn[i] == t.yarn[k];
}

/// Smallest period of the colours and yarns that divides their number.
int whole_period_of(const Threads& t) {
  const int n = t.size(), period = period_of(n, [&t](int a, int b) { return same(t, a, b); });
  return n % period == 0 ? period : n;
}

std::vector<ThreadRun> runs_of(const Threads& t, int count) {
  std::vector<ThreadRun> runs;
  for (int i = 0; i < count; ++i) {
    if (i == 0 || !same(t, i, i - 1))
      runs.push_back({t.color[static_cast<size_t>(i)], t.yarn[static_cast<size_t>(i)], 0});
    ++runs.back().threads;
  }
  return runs;
}

EdgeBinding binding(const BitMatrix& cells, int end, int first_turn) {
  // An odd number of picks turns at both edges alike: two repeats are one of the shuttle.
  const int picks = cells.rows(), round = picks % 2 == 0 ? picks : 2 * picks;
  EdgeBinding out;
  int64_t row = 0;  // missed turns in a row, over two rounds, so that a row over the border counts whole
  for (int turn = first_turn; turn < first_turn + 2 * round; turn += 2) {
    const bool missed = cells.get(turn % picks, end) == cells.get((turn + 1) % picks, end);
    row = missed ? row + 1 : 0;
    if (missed) out.unbound_picks = std::max(out.unbound_picks, 2 * (row + 1));
    if (turn >= first_turn + round) continue;
    ++out.turns;
    out.missed += missed;
  }
  return out;
}

/// Ends in the first `groups` groups.
int64_t ends_in(const std::vector<int>& raddle, int64_t groups) {
  const auto size = static_cast<int64_t>(raddle.size());
  const auto sum = [&raddle](int64_t of) { return std::accumulate(raddle.begin(), raddle.begin() + of, int64_t{0}); };
  return groups / size * sum(size) + sum(groups % size);
}

}  // namespace

// Knuth, Morris, Pratt 1977.
int period_of(int n, const std::function<bool(int, int)>& same) {
  std::vector<int> border(static_cast<size_t>(n) + 1, 0);
  for (int i = 1, k = 0; i < n; ++i) {
    while (k > 0 && !same(i, k)) k = border[static_cast<size_t>(k)];
    if (same(i, k)) ++k;
    border[static_cast<size_t>(i) + 1] = k;
  }
  return n - border[static_cast<size_t>(n)];
}

ThreadOrder thread_order(const Design& design, System system, int64_t threads) {
  const Threads& t = design.draft.threads(system);
  ThreadOrder order;
  if (t.size() == 0 || threads <= 0) return order;
  const int period = whole_period_of(t);
  order.repeat = runs_of(t, period);
  order.times = threads / period;
  order.rest = runs_of(t, static_cast<int>(threads % period));
  if (order.repeat.size() == 1) {
    order.repeat.front().threads = threads;
    order.times = 1;
    order.rest.clear();
  } else if (order.times == 0) {
    order.repeat = std::exchange(order.rest, {});
    order.times = 1;
  }
  return order;
}

Heddles heddles_for(const Draft& draft, int64_t ends) {
  Heddles out;
  out.on_shaft.resize(static_cast<size_t>(draft.shafts), 0);
  if (draft.ends() == 0) return out;
  const int64_t whole = ends / draft.ends(), more = ends % draft.ends();
  for (int e = 0; e < draft.ends(); ++e) {
    const int64_t times = whole + (e < more);
    for_each_bit(draft.threading.row(e), [&](int shaft) { out.on_shaft[static_cast<size_t>(shaft)] += times; });
    if (draft.threading.first(e) < 0) out.unthreaded_ends += times;
  }
  return out;
}

WarpingPlan warping_plan(const Design& design, const ClothMeasures& m) {
  WarpingPlan out;
  if (m.ends == 0) return out;
  constexpr int kMaxGroups = 5;
  const double ends_per_mm = m.loom_ends_per_cm / 10;
  const auto clamped = [](double ends, double most) { return std::clamp(std::round(ends), 1.0, most); };
  out.ends = m.ends + m.floating;
  out.ends_in_bout = static_cast<int64_t>(
      clamped(ends_per_mm * static_cast<double>(design.plan.bout_mm), static_cast<double>(m.ends)));
  out.bouts = (m.ends + out.ends_in_bout - 1) / out.ends_in_bout;
  out.ends_in_last = m.ends - (out.bouts - 1) * out.ends_in_bout;
  const double in_group = std::clamp(ends_per_mm * static_cast<double>(design.plan.raddle_mm), 0.1, 1e6);
  out.raddle = even_numbers(in_group, kMaxGroups);
  out.raddle_groups = dents_for(m.ends, out.raddle);
  if (out.raddle_groups > 0) out.ends_in_last_group = m.ends - ends_in(out.raddle, out.raddle_groups - 1);
  out.whole_repeats = m.ends / std::max(1, design.draft.ends());
  out.more_ends = m.ends % std::max(1, design.draft.ends());
  return out;
}

Selvedges selvedges(const BitMatrix& cells, int last_end) {
  Selvedges out;
  if (cells.rows() == 0 || cells.cols() == 0) return out;
  last_end = std::clamp(last_end, 0, cells.cols() - 1);
  for (int start = 0; start < 2; ++start) {
    // Towards the last end, the weft turns there after the first pick, and at end 1 after the second.
    auto& s = out.starts[static_cast<size_t>(start)];
    s.last = binding(cells, last_end, start);
    s.first = binding(cells, 0, 1 - start);
  }
  return out;
}

int last_end_of(const Draft& draft, int64_t ends) {
  return draft.ends() == 0 ? 0 : static_cast<int>((std::max<int64_t>(ends, 1) - 1) % draft.ends());
}

}  // namespace weftlight::analysis
