// Floats and repeats of a drawdown that repeats in both directions.
//
// Longest run of ones down the columns: P_k has a one where k ones follow one another, so
// P_(k+j)[r] = P_k[r] & P_k[r + j] for j <= k. Doubling k until nothing is left, then halving the step,
// finds the longest in log2(run) passes over whole words, however the floats lie.

#include "draft/analysis.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace weftlight::draft {
namespace {

bool any(const BitMatrix& m) {
  for (int r = 0; r < m.rows(); ++r) {
    for (const uint64_t word : m.row(r)) {
      if (word) return true;
    }
  }
  return false;
}

// m[r] & m[r + step], rows cyclic.
BitMatrix joined(const BitMatrix& m, int step) {
  BitMatrix out = BitMatrix::unset(m.rows(), m.cols());
  for (int r = 0; r < m.rows(); ++r) {
    const auto a = m.row(r), b = m.row((r + step) % m.rows());
    const auto to = out.row(r);
    for (size_t w = 0; w < to.size(); ++w) to[w] = a[w] & b[w];
  }
  return out;
}

int longest_run_down(BitMatrix m) {
  if (!any(m)) return 0;
  int run = 1;
  while (run < m.rows()) {
    const int step = std::min(run, m.rows() - run);
    BitMatrix next = joined(m, step);
    if (!any(next)) break;
    m = std::move(next);
    run += step;
  }
  for (int step = run; step > 0; step /= 2) {
    if (run + step > m.rows()) continue;
    BitMatrix next = joined(m, step);
    if (!any(next)) continue;
    m = std::move(next);
    run += step;
  }
  return run;
}

// Smallest divisor d of n for which each thread is alike to the one d before.
int smallest_period(int n, const std::function<bool(int, int)>& alike) {
  for (int d = 1; d <= n / 2; ++d) {
    if (n % d != 0) continue;
    bool repeats = true;
    for (int i = d; repeats && i < n; ++i) repeats = alike(i, i - d);
    if (repeats) return d;
  }
  return n;
}

bool same_row(const BitMatrix& m, int a, int b) {
  return std::equal(m.row(a).begin(), m.row(a).end(), m.row(b).begin());
}

bool same_thread(const Design& design, const Threads& t, int a, int b) {
  const Draft& d = design.draft;
  return d.palette[t.color[a]] == d.palette[t.color[b]] && t.spacing_mm[a] == t.spacing_mm[b] &&
         t.thickness_mm[a] == t.thickness_mm[b] && design.yarns[t.yarn[a]] == design.yarns[t.yarn[b]];
}

}  // namespace

LongestFloats longest_floats(const BitMatrix& cells) {
  const BitMatrix turned = transposed(cells);
  return {longest_run_down(cells), longest_run_down(complement(cells)), longest_run_down(complement(turned)),
          longest_run_down(turned)};
}

Repeat structure_repeat(const BitMatrix& cells) {
  const BitMatrix turned = transposed(cells);
  return {smallest_period(cells.cols(), [&](int a, int b) { return same_row(turned, a, b); }),
          smallest_period(cells.rows(), [&](int a, int b) { return same_row(cells, a, b); })};
}

Repeat design_repeat(const Design& design, const BitMatrix& cells) {
  const BitMatrix turned = transposed(cells);
  const Draft& d = design.draft;
  return {smallest_period(cells.cols(),
                          [&](int a, int b) { return same_thread(design, d.warp, a, b) && same_row(turned, a, b); }),
          smallest_period(cells.rows(),
                          [&](int a, int b) { return same_thread(design, d.weft, a, b) && same_row(cells, a, b); })};
}

double warp_up_share(const BitMatrix& cells) {
  const double crossings = static_cast<double>(cells.rows()) * cells.cols();
  return crossings > 0 ? static_cast<double>(cells.count()) / crossings : 0.0;
}

}  // namespace weftlight::draft
