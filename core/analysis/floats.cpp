// Longest run of ones down the columns: P_k has a one where k ones follow one another, so
// P_(k+j)[r] = P_k[r] & P_k[r + j] for j <= k. Doubling k until no bit is left, then halving the step, finds the
// longest run in log2(run) passes over whole words. The same doubling with OR extends the first cells of long runs
// over their whole length.

#include "analysis/floats.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace weftlight::analysis {

using draft::complement, draft::transposed;

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
BitMatrix and_shifted(const BitMatrix& m, int step) {
  BitMatrix out = BitMatrix::unset(m.rows(), m.cols());
  for (int r = 0; r < m.rows(); ++r) {
    const auto a = m.row(r), b = m.row((r + step) % m.rows());
    const auto to = out.row(r);
    for (size_t w = 0; w < to.size(); ++w) to[w] = a[w] & b[w];
  }
  return out;
}

// m[r] | m[r - step], rows cyclic.
BitMatrix or_shifted(const BitMatrix& m, int step) {
  BitMatrix out = BitMatrix::unset(m.rows(), m.cols());
  for (int r = 0; r < m.rows(); ++r) {
    const auto a = m.row(r), b = m.row((r + m.rows() - step) % m.rows());
    const auto to = out.row(r);
    for (size_t w = 0; w < to.size(); ++w) to[w] = a[w] | b[w];
  }
  return out;
}

int longest_run_down(BitMatrix m) {
  if (!any(m)) return 0;
  int run = 1;
  while (run < m.rows()) {
    const int step = std::min(run, m.rows() - run);
    BitMatrix next = and_shifted(m, step);
    if (!any(next)) break;
    m = std::move(next);
    run += step;
  }
  for (int step = run; step > 0; step /= 2) {
    if (run + step > m.rows()) continue;
    BitMatrix next = and_shifted(m, step);
    if (!any(next)) continue;
    m = std::move(next);
    run += step;
  }
  return run;
}

// Where `run` ones follow one another downwards, 1 <= run <= rows.
BitMatrix starts_of_runs(BitMatrix m, int run) {
  for (int length = 1; length < run;) {
    const int step = std::min(length, run - length);
    m = and_shifted(m, step);
    length += step;
  }
  return m;
}

// Every cell of the runs that are longer than `limit`.
BitMatrix cells_of_long_runs(const BitMatrix& m, int limit) {
  const int run = std::max(limit, 0) + 1;
  if (run > m.rows()) return BitMatrix(m.rows(), m.cols());
  BitMatrix cells = starts_of_runs(m, run);
  for (int length = 1; length < run;) {
    const int step = std::min(length, run - length);
    cells = or_shifted(cells, step);
    length += step;
  }
  return cells;
}

void or_into(BitMatrix& to, const BitMatrix& from) {
  for (int r = 0; r < to.rows(); ++r)
    for (size_t w = 0; w < to.row(r).size(); ++w) to.row(r)[w] |= from.row(r)[w];
}

// Calls visit(thread, first, length) for each run of set bits; a row is a thread, and runs continue over the edge.
template <class Visit>
void for_each_run(const BitMatrix& threads, Visit visit) {
  const int n = threads.cols();
  for (int t = 0; t < threads.rows(); ++t) {
    const auto row = threads.row(t);
    if (threads.first(t) < 0) continue;
    if (threads.count(t) == n) {
      visit(t, 0, n);
      continue;
    }
    uint64_t before = threads.get(t, n - 1);
    for (size_t w = 0; w < row.size(); ++w) {
      for (uint64_t starts = row[w] & ~(row[w] << 1 | before); starts; starts &= starts - 1) {
        const int first = static_cast<int>(w) * 64 + std::countr_zero(starts);
        int length = 1;
        while (threads.get(t, (first + length) % n)) ++length;
        visit(t, first, length);
      }
      before = row[w] >> 63;
    }
  }
}

// Counts the floats and keeps the `most` longest.
struct LongestList {
  size_t most;
  LongFloats out = {};
  int least = 0;  // floats of this length or less are not kept any more

  void add(const Float& f) {
    ++out.count;
    if (f.length <= least) return;
    out.listed.push_back(f);
    if (out.listed.size() >= 2 * most + 1024) trim();
  }
  void trim() {
    std::ranges::stable_sort(out.listed, [](const Float& a, const Float& b) { return a.length > b.length; });
    if (out.listed.size() <= most) return;
    out.listed.resize(most);
    if (most > 0) least = out.listed.back().length;
  }
};

// Runs of `down` (columns are threads of `system`) longer than the limit.
void list_runs(const BitMatrix& down, System system, Face face, int limit, LongestList& longest) {
  const BitMatrix long_cells = cells_of_long_runs(down, limit);
  if (!any(long_cells)) return;
  for_each_run(transposed(long_cells), [&](int thread, int first, int length) {
    longest.add({system, face, thread, first, length});
  });
}

/// Words [word0, word0 + words) of the rows [row0, row0 + rows).
BitMatrix part_of(const BitMatrix& m, int row0, int rows, int word0, int words) {
  BitMatrix out(rows, std::min(words * 64, m.cols() - word0 * 64));
  for (int r = 0; r < rows; ++r) std::copy_n(m.row(row0 + r).data() + word0, out.words(), out.row(r).data());
  return out;
}

}  // namespace

LongestFloats longest_floats(const BitMatrix& cells) {
  constexpr int kStripWords = 64;  // in strips, so that a large drawdown is not copied whole
  LongestFloats longest;
  for (int word0 = 0; word0 < cells.words(); word0 += kStripWords) {
    const BitMatrix strip = part_of(cells, 0, cells.rows(), word0, std::min(kStripWords, cells.words() - word0));
    longest.warp_front = std::max(longest.warp_front, longest_run_down(strip));
    longest.warp_back = std::max(longest.warp_back, longest_run_down(complement(strip)));
  }
  for (int row0 = 0; row0 < cells.rows(); row0 += kStripWords * 64) {
    const int rows = std::min(kStripWords * 64, cells.rows() - row0);
    const BitMatrix turned = transposed(part_of(cells, row0, rows, 0, cells.words()));
    longest.weft_front = std::max(longest.weft_front, longest_run_down(complement(turned)));
    longest.weft_back = std::max(longest.weft_back, longest_run_down(turned));
  }
  return longest;
}

LongFloats long_floats(const BitMatrix& cells, int limit, int most) {
  LongestList longest{static_cast<size_t>(std::max(most, 0))};
  const BitMatrix turned = transposed(cells);
  list_runs(cells, System::kWarp, Face::kFront, limit, longest);
  list_runs(complement(cells), System::kWarp, Face::kBack, limit, longest);
  list_runs(complement(turned), System::kWeft, Face::kFront, limit, longest);
  list_runs(turned, System::kWeft, Face::kBack, limit, longest);
  longest.trim();
  return std::move(longest.out);
}

BitMatrix crossings_in_floats(const BitMatrix& cells, int limit, Face face) {
  const BitMatrix warp_up = face == Face::kFront ? cells : complement(cells);
  BitMatrix out = cells_of_long_runs(warp_up, limit);
  or_into(out, transposed(cells_of_long_runs(complement(transposed(warp_up)), limit)));
  return out;
}

}  // namespace weftlight::analysis
