// The smallest set of treadles (sets of shafts) of which every lift is the union of at most n, the treadles per pick.
//
// A treadle may be tied to every shaft that all its picks lift, so only intersections of lifts need be tried. Branch
// and bound: of the lifts that are left, the one with the fewest combinations is decided next, combinations with the
// fewest new treadles first. Lower bound: t treadles make at most sum over k <= n of C(t, k) lifts. For n = 1 each
// distinct lift is a treadle.
// Based on: the set basis problem (L. J. Stockmeyer, The set basis problem is NP-complete, 1975).

#include "draft/skeleton.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace weftlight::draft {
namespace {

using Set = std::vector<uint64_t>;  // of shafts

constexpr size_t kMaxCandidates = 1024;
constexpr size_t kMaxLifts = 256;         // distinct; with more, each has its own treadle
constexpr size_t kMaxCombinations = 256;  // combinations of treadles for one lift

bool within(const Set& a, const Set& b) {
  for (size_t w = 0; w < a.size(); ++w)
    if (a[w] & ~b[w]) return false;
  return true;
}

Set united(Set a, const Set& b) {
  for (size_t w = 0; w < a.size(); ++w) a[w] |= b[w];
  return a;
}

Set common(Set a, const Set& b) {
  for (size_t w = 0; w < a.size(); ++w) a[w] &= b[w];
  return a;
}

bool is_empty(const Set& a) {
  return std::ranges::all_of(a, [](uint64_t word) { return word == 0; });
}

int size_of(const Set& a) {
  return std::accumulate(a.begin(), a.end(), 0, [](int sum, uint64_t word) { return sum + std::popcount(word); });
}

// The lifts, then their intersections, of two and more.
std::vector<Set> candidates_of(const std::vector<Set>& lifts, const base::TaskProgress& progress) {
  std::vector<Set> found = lifts;
  for (size_t i = 0; i < found.size() && found.size() < kMaxCandidates && !progress.stopped(); ++i)
    for (size_t k = 0; k < lifts.size() && found.size() < kMaxCandidates; ++k) {
      Set both = common(found[i], lifts[k]);
      if (!is_empty(both) && std::ranges::find(found, both) == found.end()) found.push_back(std::move(both));
    }
  return found;
}

using Combination = std::vector<int>;  // candidates whose union is a lift

void add_combinations(std::vector<Combination>& combinations, const std::vector<Set>& all,
                      const std::vector<int>& inside, const Set& lift, size_t from, const Combination& combination,
                      const Set& sum, int most) {
  for (size_t i = from; i < inside.size() && combinations.size() < kMaxCombinations; ++i) {
    const Set& next = all[static_cast<size_t>(inside[i])];
    if (within(next, sum)) continue;
    Combination more = combination;
    more.push_back(inside[i]);
    const Set now = united(sum, next);
    if (now == lift) combinations.push_back(std::move(more));
    else if (most > 1) add_combinations(combinations, all, inside, lift, i + 1, more, now, most - 1);
  }
}

std::vector<Combination> combinations_of(const std::vector<Set>& all, const Set& lift, int most) {
  std::vector<int> inside;
  for (size_t i = 0; i < all.size(); ++i)
    if (within(all[i], lift)) inside.push_back(static_cast<int>(i));
  // Largest first: if the number of combinations is capped, those of many small treadles are left out.
  std::ranges::stable_sort(inside, [&](int a, int b) {
    return size_of(all[static_cast<size_t>(a)]) > size_of(all[static_cast<size_t>(b)]);
  });
  std::vector<Combination> combinations;
  add_combinations(combinations, all, inside, lift, 0, {}, Set(lift.size(), 0), most);
  return combinations;
}

// Lower bound: the fewest treadles with at least `lifts` unions.
int least_treadles(int64_t lifts, int most) {
  for (int t = 0;; ++t) {
    int64_t made = 0, choose = 1;
    for (int k = 1; k <= most && k <= t; ++k) {
      choose = choose * (t - k + 1) / k;
      made += choose;
    }
    if (made >= lifts) return t;
  }
}

struct Search {
  explicit Search(const base::TaskProgress& p) : progress(p) {}

  const base::TaskProgress& progress;
  std::vector<std::vector<Combination>> combinations;  // of each lift
  int at_least = 0, steps = 0;
  std::vector<int> uses;    // of each candidate: number of lifts that use it
  std::vector<int> chosen;  // combination of each lift; -1: undecided
  int treadles = 0;
  std::vector<int> best_chosen;
  int best = 0;
  int all_steps = 0, told_steps = 0;

  // True when the search is to end. Reports the progress now and then.
  bool is_over() {
    constexpr int kTold = 1 << 16;
    if (told_steps - steps >= kTold) {
      told_steps = steps;
      progress.report(1 - static_cast<float>(std::max(steps, 0)) / static_cast<float>(all_steps));
    }
    return steps <= 0 || progress.stopped();
  }
  int new_treadles(const Combination& combination) const {
    return static_cast<int>(
        std::ranges::count_if(combination, [this](int c) { return uses[static_cast<size_t>(c)] == 0; }));
  }
  void use(const Combination& combination, int by) {
    for (const int c : combination) {
      int& times = uses[static_cast<size_t>(c)];
      treadles += by > 0 && times == 0;
      times += by;
      treadles -= by < 0 && times == 0;
    }
  }
  // The lift to decide next: one that needs no new treadle, otherwise the one with the fewest combinations.
  int next_lift() {
    int next = -1;
    for (size_t i = 0; i < combinations.size(); ++i) {
      if (chosen[i] >= 0) continue;
      steps -= static_cast<int>(combinations[i].size());
      for (const Combination& combination : combinations[i])
        if (new_treadles(combination) == 0) return static_cast<int>(i);
      if (next < 0 || combinations[i].size() < combinations[static_cast<size_t>(next)].size())
        next = static_cast<int>(i);
    }
    return next;
  }
  void run() {
    --steps;
    if (is_over() || best <= at_least || treadles >= best) return;
    const int lift = next_lift();
    if (lift < 0) {
      best = treadles;
      best_chosen = chosen;
      return;
    }
    if (treadles + 1 >= best &&
        std::ranges::none_of(combinations[static_cast<size_t>(lift)],
                             [this](const Combination& combination) { return new_treadles(combination) == 0; }))
      return;
    const std::vector<Combination>& here = combinations[static_cast<size_t>(lift)];
    std::vector<int> order(here.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](int w) { return new_treadles(here[static_cast<size_t>(w)]); });
    const bool free = new_treadles(here[static_cast<size_t>(order.front())]) == 0;
    for (const int w : order) {
      chosen[static_cast<size_t>(lift)] = w;
      use(here[static_cast<size_t>(w)], 1);
      run();
      use(here[static_cast<size_t>(w)], -1);
      chosen[static_cast<size_t>(lift)] = -1;
      if (free || is_over()) return;  // a combination without new treadles is never worse
    }
  }
};

}  // namespace

Skeleton skeleton_tieup(const BitMatrix& lifts, int treadles_per_pick, const base::TaskProgress& progress, int steps) {
  int most = std::clamp(treadles_per_pick, 1, 4);
  const std::vector<int> first = first_equal_rows(lifts);
  std::vector<Set> distinct;
  std::vector<int> lift_of(first.size(), -1);
  for (int p = 0; p < lifts.rows(); ++p) {
    if (lifts.first(p) < 0) continue;
    if (first[p] == p) {
      lift_of[p] = static_cast<int>(distinct.size());
      distinct.emplace_back(lifts.row(p).begin(), lifts.row(p).end());
    }
    lift_of[p] = lift_of[first[p]];
  }
  if (distinct.size() > kMaxLifts) most = 1;
  const std::vector<Set> all = most > 1 ? candidates_of(distinct, progress) : distinct;
  Search search(progress);
  bool all_combinations = all.size() < kMaxCandidates;
  for (size_t i = 0; i < distinct.size(); ++i) {
    const bool alone = most == 1 || progress.stopped();
    search.combinations.push_back(alone ? std::vector<Combination>{{static_cast<int>(i)}}
                                        : combinations_of(all, distinct[i], most));
    search.best_chosen.push_back(0);
    all_combinations = all_combinations && search.combinations.back().size() < kMaxCombinations;
  }
  // A treadle per lift is the fallback: the largest candidate inside a lift is the lift itself, its first combination.
  search.best = static_cast<int>(distinct.size());
  search.at_least = least_treadles(static_cast<int64_t>(distinct.size()), most);
  search.steps = search.all_steps = search.told_steps = steps;
  search.uses.assign(all.size(), 0);
  search.chosen.assign(distinct.size(), -1);
  search.run();

  Skeleton out;
  out.at_least = search.at_least;
  out.fewest = search.best == search.at_least || (search.steps > 0 && all_combinations && !progress.stopped());
  std::vector<int> treadle_of(all.size(), -1), order;
  out.treadling = BitMatrix(lifts.rows(), search.best);
  for (int p = 0; p < lifts.rows(); ++p) {
    if (lift_of[p] < 0) continue;
    const auto lift = static_cast<size_t>(lift_of[p]);
    for (const int c : search.combinations[lift][static_cast<size_t>(search.best_chosen[lift])]) {
      int& treadle = treadle_of[static_cast<size_t>(c)];
      if (treadle < 0) {
        treadle = static_cast<int>(order.size());
        order.push_back(c);
      }
      out.treadling.set(p, treadle, true);
    }
  }
  out.tieup = BitMatrix(static_cast<int>(order.size()), lifts.cols());
  for (size_t t = 0; t < order.size(); ++t)
    std::ranges::copy(all[static_cast<size_t>(order[t])], out.tieup.row(static_cast<int>(t)).begin());
  return out;
}

}  // namespace weftlight::draft
