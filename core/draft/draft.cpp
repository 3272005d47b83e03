#include "draft/draft.h"

#include <algorithm>

namespace weftlight::draft {

void Threads::resize(int n, int new_color) {
  const auto count = static_cast<size_t>(std::max(n, 0));
  color.resize(count, new_color);
  spacing_mm.resize(count, kFromYarn);
  thickness_mm.resize(count, kFromYarn);
  yarn.resize(count, 0);
}

Draft blank_draft(int ends, int picks, int shafts, int treadles) {
  Draft d;
  d.shafts = shafts;
  d.treadles = treadles;
  d.threading = BitMatrix(ends, shafts);
  d.tieup = BitMatrix(treadles, shafts);
  d.treadling = BitMatrix(picks, treadles);
  d.liftplan = BitMatrix(picks, shafts);
  d.warp.resize(ends, 0);
  d.weft.resize(picks, 1);
  d.palette = {Rgb{0, 0, 0}, Rgb{1, 1, 1}};
  return d;
}

namespace {

bool has_size(const BitMatrix& m, int rows, int cols) { return m.rows() == rows && m.cols() == cols; }

bool in_range(const std::vector<int>& indices, size_t limit) {
  return std::all_of(indices.begin(), indices.end(),
                     [limit](int i) { return i >= 0 && static_cast<size_t>(i) < limit; });
}

bool is_consistent(const Threads& t, size_t colors, size_t yarns) {
  const size_t n = t.color.size();
  return n <= static_cast<size_t>(kMaxThreads) && t.spacing_mm.size() == n && t.thickness_mm.size() == n &&
         t.yarn.size() == n && in_range(t.color, colors) && in_range(t.yarn, yarns);
}

}  // namespace

bool is_consistent(const Draft& d, size_t yarns) {
  const bool counts = d.shafts >= 0 && d.shafts <= kMaxShafts && d.treadles >= 0 && d.treadles <= kMaxShafts &&
                      d.palette.size() <= static_cast<size_t>(kMaxColors) && int64_t{d.ends()} * d.picks() <= kMaxCells;
  return counts && has_size(d.threading, d.ends(), d.shafts) && has_size(d.tieup, d.treadles, d.shafts) &&
         has_size(d.treadling, d.picks(), d.treadles) && has_size(d.liftplan, d.picks(), d.shafts) &&
         is_consistent(d.warp, d.palette.size(), yarns) && is_consistent(d.weft, d.palette.size(), yarns);
}

}  // namespace weftlight::draft
