#include "draft/repeat.h"

#include <algorithm>
#include <functional>

namespace weftlight::draft {
namespace {

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
