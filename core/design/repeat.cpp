#include "design/repeat.h"

#include <algorithm>
#include <functional>

#include "design/dye.h"

namespace weftlight::design {

using draft::Draft, draft::Threads;

namespace {

// Smallest divisor d of n such that each thread equals the one d before it.
int smallest_period(int n, const std::function<bool(int, int)>& equal) {
  for (int d = 1; d <= n / 2; ++d) {
    if (n % d != 0) continue;
    bool repeats = true;
    for (int i = d; repeats && i < n; ++i) repeats = equal(i, i - d);
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

/// Whether each row equals itself shifted by d columns.
bool repeats_across(const BitMatrix& m, int d) {
  const int left = m.cols() - d, words = (left + 63) / 64, shift = d % 64;
  const uint64_t tail = left % 64 == 0 ? ~uint64_t{0} : (uint64_t{1} << (left % 64)) - 1;
  for (int r = 0; r < m.rows(); ++r) {
    const auto row = m.row(r);
    for (int w = 0; w < words; ++w) {
      const size_t from = static_cast<size_t>(w + d / 64);
      uint64_t moved = row[from] >> shift;
      if (shift > 0 && from + 1 < row.size()) moved |= row[from + 1] << (64 - shift);
      const uint64_t differ = moved ^ row[static_cast<size_t>(w)];
      if ((w + 1 == words ? differ & tail : differ) != 0) return false;
    }
  }
  return true;
}

bool always(int, int) { return true; }

/// Smallest divisor d of the number of columns such that the cells repeat after d columns and each thread equals the
/// one d before it.
int smallest_column_period(const BitMatrix& cells, const std::function<bool(int, int)>& equal) {
  const int n = cells.cols();
  for (int d = 1; d <= n / 2; ++d) {
    if (n % d != 0) continue;
    bool repeats = true;
    for (int i = d; repeats && i < n; ++i) repeats = equal(i, i - d);
    if (repeats && repeats_across(cells, d)) return d;
  }
  return n;
}

}  // namespace

Repeat structure_repeat(const BitMatrix& cells) {
  return {smallest_column_period(cells, always),
          smallest_period(cells.rows(), [&](int a, int b) { return same_row(cells, a, b); })};
}

Repeat design_repeat(const Design& design, const BitMatrix& cells) {
  const Draft& d = design.draft;
  const DyedThreads dyes(design);
  const auto equal = [&](System system, int a, int b) {
    const System across = system == System::kWarp ? System::kWeft : System::kWarp;
    return same_thread(design, d.threads(system), a, b) && dyes.phase(system, a) == dyes.phase(system, b) &&
           dyes.repeat_after(across, a - b);
  };
  return {
      smallest_column_period(cells, [&](int a, int b) { return equal(System::kWarp, a, b); }),
      smallest_period(cells.rows(), [&](int a, int b) { return equal(System::kWeft, a, b) && same_row(cells, a, b); })};
}

double warp_up_fraction(const BitMatrix& cells) {
  const double crossings = static_cast<double>(cells.rows()) * cells.cols();
  return crossings > 0 ? static_cast<double>(cells.count()) / crossings : 0.0;
}

}  // namespace weftlight::design
