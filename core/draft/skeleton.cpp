// The fewest sets of shafts of which every lift is the union of at most `feet`.
//
// A treadle may be tied to all shafts that the picks which use it have in common without harm, so only
// intersections of lifts need be tried. Branch and bound: the lift with the fewest ways to be made is made in
// each of its ways, those with the fewest new treadles first; t treadles make at most sum over k <= feet of
// C(t, k) lifts, which bounds a branch from below. With one foot it is each distinct lift by itself.
// Based on: the set basis problem (L. J. Stockmeyer, The set basis problem is NP-complete, 1975).

#include "draft/skeleton.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace weftlight::draft {
namespace {

using Set = std::vector<uint64_t>;  // of shafts

constexpr size_t kMaxCandidates = 1024;
constexpr size_t kMaxLifts = 256;  // that are tried in pairs; of more each has a treadle of its own
constexpr size_t kMaxWays = 256;   // of making one lift

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

// The lifts, then what they have in common, by twos and further.
std::vector<Set> candidates_of(const std::vector<Set>& lifts) {
  std::vector<Set> found = lifts;
  for (size_t i = 0; i < found.size() && found.size() < kMaxCandidates; ++i)
    for (size_t k = 0; k < lifts.size() && found.size() < kMaxCandidates; ++k) {
      Set both = common(found[i], lifts[k]);
      if (!is_empty(both) && std::ranges::find(found, both) == found.end()) found.push_back(std::move(both));
    }
  return found;
}

using Way = std::vector<int>;  // candidates that together are a lift

void add_ways(std::vector<Way>& ways, const std::vector<Set>& all, const std::vector<int>& inside, const Set& lift,
              size_t from, const Way& way, const Set& sum, int feet) {
  for (size_t i = from; i < inside.size() && ways.size() < kMaxWays; ++i) {
    const Set& next = all[static_cast<size_t>(inside[i])];
    if (within(next, sum)) continue;
    Way more = way;
    more.push_back(inside[i]);
    const Set now = united(sum, next);
    if (now == lift) ways.push_back(std::move(more));
    else if (feet > 1) add_ways(ways, all, inside, lift, i + 1, more, now, feet - 1);
  }
}

std::vector<Way> ways_of(const std::vector<Set>& all, const Set& lift, int feet) {
  std::vector<int> inside;
  for (size_t i = 0; i < all.size(); ++i)
    if (within(all[i], lift)) inside.push_back(static_cast<int>(i));
  // The largest first: where not all ways are kept, those of many tiny treadles are left out.
  std::ranges::stable_sort(inside, [&](int a, int b) {
    return size_of(all[static_cast<size_t>(a)]) > size_of(all[static_cast<size_t>(b)]);
  });
  std::vector<Way> ways;
  add_ways(ways, all, inside, lift, 0, {}, Set(lift.size(), 0), feet);
  return ways;
}

// Fewest treadles that make `lifts` different lifts.
int least_treadles(int64_t lifts, int feet) {
  for (int t = 0;; ++t) {
    int64_t made = 0, choose = 1;
    for (int k = 1; k <= feet && k <= t; ++k) {
      choose = choose * (t - k + 1) / k;
      made += choose;
    }
    if (made >= lifts) return t;
  }
}

struct Search {
  std::vector<std::vector<Way>> ways;  // of each lift
  int at_least = 0, steps = 0;
  std::vector<int> uses;    // of each candidate: lifts made with it
  std::vector<int> chosen;  // way of each lift, -1: not yet made
  int treadles = 0;
  std::vector<int> best_chosen;
  int best = 0;

  int new_treadles(const Way& way) const {
    return static_cast<int>(std::ranges::count_if(way, [this](int c) { return uses[static_cast<size_t>(c)] == 0; }));
  }
  void use(const Way& way, int by) {
    for (const int c : way) {
      int& times = uses[static_cast<size_t>(c)];
      treadles += by > 0 && times == 0;
      times += by;
      treadles -= by < 0 && times == 0;
    }
  }
  // The lift that most needs a decision: one that costs nothing, or else the one with the fewest ways.
  int next_lift() {
    int next = -1;
    for (size_t i = 0; i < ways.size(); ++i) {
      if (chosen[i] >= 0) continue;
      steps -= static_cast<int>(ways[i].size());
      for (const Way& way : ways[i])
        if (new_treadles(way) == 0) return static_cast<int>(i);
      if (next < 0 || ways[i].size() < ways[static_cast<size_t>(next)].size()) next = static_cast<int>(i);
    }
    return next;
  }
  void go() {
    if (steps-- <= 0 || best <= at_least || treadles >= best) return;
    const int lift = next_lift();
    if (lift < 0) {
      best = treadles;
      best_chosen = chosen;
      return;
    }
    if (treadles + 1 >= best && std::ranges::none_of(ways[static_cast<size_t>(lift)],
                                                     [this](const Way& way) { return new_treadles(way) == 0; }))
      return;
    const std::vector<Way>& here = ways[static_cast<size_t>(lift)];
    std::vector<int> order(here.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](int w) { return new_treadles(here[static_cast<size_t>(w)]); });
    const bool free = new_treadles(here[static_cast<size_t>(order.front())]) == 0;
    for (const int w : order) {
      chosen[static_cast<size_t>(lift)] = w;
      use(here[static_cast<size_t>(w)], 1);
      go();
      use(here[static_cast<size_t>(w)], -1);
      chosen[static_cast<size_t>(lift)] = -1;
      if (free || steps <= 0) return;  // what costs nothing is never worse
    }
  }
};

}  // namespace

Skeleton skeleton_tieup(const BitMatrix& lifts, int feet, int steps) {
  feet = std::clamp(feet, 1, 4);
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
  if (distinct.size() > kMaxLifts) feet = 1;
  const std::vector<Set> all = feet > 1 ? candidates_of(distinct) : distinct;
  Search search;
  bool all_ways = all.size() < kMaxCandidates;
  for (size_t i = 0; i < distinct.size(); ++i) {
    search.ways.push_back(feet > 1 ? ways_of(all, distinct[i], feet) : std::vector<Way>{{static_cast<int>(i)}});
    search.best_chosen.push_back(0);
    all_ways = all_ways && search.ways.back().size() < kMaxWays;
  }
  // Each lift by a treadle of its own is always a way: the largest set inside it is itself, and comes first.
  search.best = static_cast<int>(distinct.size());
  search.at_least = least_treadles(static_cast<int64_t>(distinct.size()), feet);
  search.steps = steps;
  search.uses.assign(all.size(), 0);
  search.chosen.assign(distinct.size(), -1);
  search.go();

  Skeleton out;
  out.at_least = search.at_least;
  out.fewest = search.best == search.at_least || (search.steps > 0 && all_ways);
  std::vector<int> treadle_of(all.size(), -1), order;
  out.treadling = BitMatrix(lifts.rows(), search.best);
  for (int p = 0; p < lifts.rows(); ++p) {
    if (lift_of[p] < 0) continue;
    const auto lift = static_cast<size_t>(lift_of[p]);
    for (const int c : search.ways[lift][static_cast<size_t>(search.best_chosen[lift])]) {
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
