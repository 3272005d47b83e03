// Finds the threads that can be lifted off the rest.
//
// A set of p ends and q picks lies on top of the rest if each of its ends is over each pick outside the set, and each
// of its picks over each end outside. Whichever thread is over at the p q crossings within, the set is then over at
// p (P - q) + q (E - p) + p q crossings, the maximum. So only the p ends and the q picks that are over most often need
// be tried, and for each p the q with the smallest deficit.
// Based on: C. R. J. Clapham, When a fabric hangs together, 1980; T. C. Enns, An efficient algorithm
// determining when a fabric hangs together, 1984.
// Differs: all cuts are listed, not only the first, so that every layer is found.

#include "analysis/weave_layers.h"

#include <algorithm>
#include <numeric>

namespace weftlight::analysis {

using draft::transposed;

namespace {

// Threads of one system, those most often on top first.
struct Ranked {
  std::vector<int> order;
  std::vector<int64_t> over;  // crossings at which order[i] is on top
  int size() const { return static_cast<int>(order.size()); }
};

// Each row is a thread; a set bit is a crossing where it is on top if `ones`, underneath if not.
Ranked rank(const BitMatrix& threads, bool ones) {
  std::vector<int64_t> over;
  for (int r = 0; r < threads.rows(); ++r) {
    const int64_t set = threads.count(r);
    over.push_back(ones ? set : threads.cols() - set);
  }
  Ranked ranked{std::vector<int>(over.size()), {}};
  std::iota(ranked.order.begin(), ranked.order.end(), 0);
  std::ranges::stable_sort(ranked.order, [&](int a, int b) { return over[a] > over[b]; });
  for (const int thread : ranked.order) ranked.over.push_back(over[thread]);
  return ranked;
}

struct Cut {
  int ends = 0, picks = 0;  // numbers of threads above it
};

std::vector<Cut> cuts(const Ranked& ends, const Ranked& picks) {
  std::vector<Cut> found;
  int64_t deficit_ends = 0;  // crossings at which an end above the cut is under
  int64_t deficit_picks = 0;
  int q = 0;
  for (int p = 0; p <= ends.size(); ++p) {
    if (p > 0) deficit_ends += picks.size() - ends.over[p - 1];
    // Each pick above the cut is under E - over ends. At each of the p q crossings within, one of the two threads
    // is under, so the set is on top if the deficit is exactly p q.
    while (q < picks.size() && ends.size() - picks.over[q] < p) {
      deficit_picks += ends.size() - picks.over[q++];
    }
    if (deficit_ends + deficit_picks != int64_t{p} * q) continue;
    found.push_back({p, q});
    // A pick that is under exactly the ends above may lie on either side of the cut.
    for (int tied = q; tied < picks.size() && ends.size() - picks.over[tied] == p; ++tied) {
      found.push_back({p, tied + 1});
    }
  }
  return found;
}

}  // namespace

std::vector<WeaveLayer> weave_layers(const BitMatrix& cells) {
  const Ranked ends = rank(transposed(cells), true), picks = rank(cells, false);
  std::vector<WeaveLayer> out;
  Cut above;
  for (const Cut cut : cuts(ends, picks)) {
    if (cut.ends == above.ends && cut.picks == above.picks) continue;
    WeaveLayer layer{{ends.order.begin() + above.ends, ends.order.begin() + cut.ends},
                     {picks.order.begin() + above.picks, picks.order.begin() + cut.picks}};
    std::ranges::sort(layer.ends);
    std::ranges::sort(layer.picks);
    out.push_back(std::move(layer));
    above = cut;
  }
  return out;
}

}  // namespace weftlight::analysis
