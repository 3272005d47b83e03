// The drawdown from lifts.
//
// A row of the drawdown is the OR, over the named shafts, of the bitsets of their ends. Picks with equal lifts share
// one computed row. If many lifts differ, eight shafts at a time are looked up in a table with the OR of every subset,
// in strips of ends narrow enough for the tables to stay in the cache.
// Based on: V. L. Arlazarov, E. A. Dinic, M. A. Kronrod, I. A. Faradzev, "On economical construction of
// the transitive closure of a directed graph", 1970 (the method of four Russians).

#include "draft/drawdown.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace weftlight::draft {
namespace {

constexpr int kGroup = 8;  // shafts per table
constexpr int kSubsets = 1 << kGroup;
constexpr int kTableWords = 2 * 1024 * 1024 / 8;  // of all tables of a strip: fits the level-3 cache
constexpr int kLine = 8;                          // words per cache line

void or_into(uint64_t* to, const uint64_t* from, int words) {
  for (int w = 0; w < words; ++w) to[w] |= from[w];
}

// The ends of each shaft, and all ends that are on a shaft.
struct Harness {
  BitMatrix ends_of;  // shafts x ends
  std::vector<uint64_t> threaded;
  bool rising = true;
};

Harness make_harness(const Draft& draft) {
  Harness h{transposed(draft.threading), {}, draft.rising};
  h.threaded.assign(static_cast<size_t>(h.ends_of.words()), 0);
  for (int s = 0; s < h.ends_of.rows(); ++s) {
    or_into(h.threaded.data(), h.ends_of.row(s).data(), h.ends_of.words());
  }
  return h;
}

void sink(uint64_t* row, const uint64_t* threaded, int words) {
  for (int w = 0; w < words; ++w) row[w] = threaded[w] & ~row[w];
}

void direct_row(const Harness& h, std::span<const uint64_t> lift, std::span<uint64_t> row) {
  const int words = h.ends_of.words();
  std::fill(row.begin(), row.end(), 0);
  for_each_bit(lift, [&](int shaft) { or_into(row.data(), h.ends_of.row(shaft).data(), words); });
  if (!h.rising) sink(row.data(), h.threaded.data(), words);
}

// Fills the tables of the strip [word0, word0 + words): entry (group, subset) is the OR of the subset's shafts.
void fill_tables(std::vector<uint64_t>& tables, const Harness& h, int word0, int words) {
  const int groups = (h.ends_of.rows() + kGroup - 1) / kGroup;
  for (int g = 0; g < groups; ++g) {
    uint64_t* table = tables.data() + static_cast<size_t>(g) * kSubsets * words;
    std::fill_n(table, words, 0);
    for (int subset = 1; subset < kSubsets; ++subset) {
      const int shaft = g * kGroup + std::countr_zero(static_cast<unsigned>(subset));
      uint64_t* entry = table + static_cast<size_t>(subset) * words;
      std::copy_n(table + static_cast<size_t>(subset & (subset - 1)) * words, words, entry);
      if (shaft < h.ends_of.rows()) or_into(entry, h.ends_of.row(shaft).data() + word0, words);
    }
  }
}

unsigned subset_of(std::span<const uint64_t> lift, int group) {
  return static_cast<unsigned>(lift[static_cast<size_t>(group) / 8] >> (group % 8 * kGroup)) & (kSubsets - 1);
}

// Writes the OR of one entry of each table, one cache line at a time so that the sum stays in registers.
void look_up_row(uint64_t* row, const std::vector<const uint64_t*>& entries, int words) {
  int w = 0;
  for (; w + kLine <= words; w += kLine) {
    std::array<uint64_t, kLine> line{};
    for (const uint64_t* entry : entries) {
      for (int i = 0; i < kLine; ++i) line[i] |= entry[w + i];
    }
    std::copy(line.begin(), line.end(), row + w);
  }
  for (; w < words; ++w) {
    row[w] = 0;
    for (const uint64_t* entry : entries) row[w] |= entry[w];
  }
}

void table_rows(BitMatrix& cells, const Harness& h, const BitMatrix& lift, const std::vector<int>& picks) {
  const int groups = (h.ends_of.rows() + kGroup - 1) / kGroup;
  const int strip = std::max(1, kTableWords / (groups * kSubsets * kLine)) * kLine;
  std::vector<uint64_t> tables(static_cast<size_t>(groups) * kSubsets * strip);
  std::vector<const uint64_t*> entries(static_cast<size_t>(groups));
  for (int word0 = 0; word0 < cells.words(); word0 += strip) {
    const int words = std::min(strip, cells.words() - word0);
    fill_tables(tables, h, word0, words);
    for (const int pick : picks) {
      uint64_t* row = cells.row(pick).data() + word0;
      for (int g = 0; g < groups; ++g) {
        const unsigned subset = subset_of(lift.row(pick), g);
        entries[g] = tables.data() + (static_cast<size_t>(g) * kSubsets + subset) * words;
      }
      look_up_row(row, entries, words);
      if (!h.rising) sink(row, h.threaded.data() + word0, words);
    }
  }
}

bool tables_are_faster(const BitMatrix& lift, const std::vector<int>& picks) {
  int64_t direct = 0;
  for (const int p : picks) direct += lift.count(p);
  const int64_t groups = (lift.cols() + kGroup - 1) / kGroup;
  return groups * (kSubsets + static_cast<int64_t>(picks.size())) < direct;
}

BitMatrix drawdown_of(const Harness& h, const BitMatrix& lift, int ends) {
  BitMatrix cells = BitMatrix::unset(lift.rows(), ends);
  const std::vector<int> first = first_equal_rows(lift);
  std::vector<int> distinct;
  for (int p = 0; p < lift.rows(); ++p) {
    if (first[p] == p) distinct.push_back(p);
  }
  if (tables_are_faster(lift, distinct)) {
    table_rows(cells, h, lift, distinct);
  } else {
    for (const int p : distinct) direct_row(h, lift.row(p), cells.row(p));
  }
  for (int p = 0; p < lift.rows(); ++p) {
    if (first[p] != p) std::copy_n(cells.row(first[p]).data(), cells.words(), cells.row(p).data());
  }
  return cells;
}

// Grows `rect` to include a cell.
void include(CellRect& rect, int end, int pick) {
  if (rect.empty()) {
    rect = {end, end + 1, pick, pick + 1};
    return;
  }
  rect = {std::min(rect.end0, end), std::max(rect.end1, end + 1), std::min(rect.pick0, pick),
          std::max(rect.pick1, pick + 1)};
}

void include_difference(CellRect& rect, int pick, std::span<const uint64_t> was, std::span<const uint64_t> is) {
  int low = -1, high = -1;
  for (size_t w = 0; w < was.size(); ++w) {
    const uint64_t changed = was[w] ^ is[w];
    if (!changed) continue;
    if (low < 0) low = static_cast<int>(w) * 64 + std::countr_zero(changed);
    high = static_cast<int>(w) * 64 + 63 - std::countl_zero(changed);
  }
  if (low < 0) return;
  include(rect, low, pick);
  include(rect, high, pick);
}

CellRect replace_all(BitMatrix& cells, BitMatrix next) {
  CellRect rect;
  if (cells.rows() != next.rows() || cells.cols() != next.cols()) {
    rect = {0, next.cols(), 0, next.rows()};
  } else {
    for (int p = 0; p < next.rows(); ++p) include_difference(rect, p, cells.row(p), next.row(p));
  }
  cells = std::move(next);
  return rect;
}

/// Of rows of any widths: whether they differ in a column of `mask`.
bool differ(std::span<const uint64_t> a, std::span<const uint64_t> b, std::span<const uint64_t> mask) {
  for (size_t w = 0; w < mask.size(); ++w) {
    const uint64_t in_a = w < a.size() ? a[w] : 0, in_b = w < b.size() ? b[w] : 0;
    if ((in_a ^ in_b) & mask[w]) return true;
  }
  return false;
}

std::vector<int> changed_rows(const BitMatrix& was, const BitMatrix& is, const std::vector<uint64_t>& mask) {
  std::vector<int> rows;
  for (int r = 0; r < is.rows(); ++r) {
    if (differ(was.row(r), is.row(r), mask)) rows.push_back(r);
  }
  return rows;
}

/// The shafts of all ends but these, which are ascending.
std::vector<uint64_t> shafts_of_others(const BitMatrix& threading, const std::vector<int>& ends) {
  std::vector<uint64_t> shafts(static_cast<size_t>(threading.words()), 0);
  for (int e = 0; e < threading.rows(); ++e) {
    if (!std::ranges::binary_search(ends, e)) or_into(shafts.data(), threading.row(e).data(), threading.words());
  }
  return shafts;
}

void update_picks(BitMatrix& cells, const Draft& draft, const BitMatrix& lift, const std::vector<int>& picks,
                  CellRect& rect) {
  if (picks.empty()) return;
  const Harness harness = make_harness(draft);
  std::vector<uint64_t> row(static_cast<size_t>(cells.words()));
  for (const int p : picks) {
    direct_row(harness, lift.row(p), row);
    include_difference(rect, p, cells.row(p), row);
    std::copy(row.begin(), row.end(), cells.row(p).begin());
  }
}

}  // namespace

BitMatrix lifts(const Draft& draft) {
  if (draft.shed_control == ShedControl::kLiftplan) return draft.liftplan;
  BitMatrix out(draft.picks(), draft.shafts);
  for (int p = 0; p < draft.picks(); ++p) {
    for_each_bit(draft.treadling.row(p),
                 [&](int treadle) { or_into(out.row(p).data(), draft.tieup.row(treadle).data(), out.words()); });
  }
  return out;
}

BitMatrix drawdown(const Draft& draft) { return drawdown_of(make_harness(draft), lifts(draft), draft.ends()); }

BitMatrix drawdown_columns(const Draft& draft, const std::vector<int>& ends) {
  const BitMatrix named = transposed(lifts(draft));
  BitMatrix out(static_cast<int>(ends.size()), draft.picks());
  for (int i = 0; i < out.rows(); ++i) {
    const std::span<uint64_t> column = out.row(i);
    const std::span<const uint64_t> shafts = draft.threading.row(ends[i]);
    for_each_bit(shafts, [&](int shaft) { or_into(column.data(), named.row(shaft).data(), out.words()); });
    if (draft.rising || draft.threading.first(ends[i]) < 0 || column.empty()) continue;
    for (uint64_t& word : column) word = ~word;
    column.back() &= out.last_word_mask();
  }
  return out;
}

namespace {

void update_ends(BitMatrix& cells, const Draft& before, const Draft& after, const std::vector<int>& ends,
                 CellRect& rect) {
  const BitMatrix was = drawdown_columns(before, ends), is = drawdown_columns(after, ends);
  for (int i = 0; i < is.rows(); ++i) {
    for (size_t w = 0; w < is.row(i).size(); ++w) {
      for (uint64_t changed = was.row(i)[w] ^ is.row(i)[w]; changed; changed &= changed - 1) {
        const int pick = static_cast<int>(w) * 64 + std::countr_zero(changed);
        cells.set(pick, ends[i], is.get(i, pick));
        include(rect, ends[i], pick);
      }
    }
  }
}

}  // namespace

CellRect update_drawdown(BitMatrix& cells, const Draft& before, const Draft& after) {
  const bool same_shape = before.ends() == after.ends() && before.picks() == after.picks() &&
                          cells.rows() == after.picks() && cells.cols() == after.ends();
  if (!same_shape || before.rising != after.rising) return replace_all(cells, drawdown(after));

  const BitMatrix lift = lifts(after);
  const std::vector<uint64_t> any_shaft(static_cast<size_t>(std::max(before.threading.words(), lift.words())),
                                        ~uint64_t{0});
  const std::vector<int> ends = changed_rows(before.threading, after.threading, any_shaft);
  // A change of an end may be one of every row; above 1/64 of the ends the whole drawdown is cheaper.
  const bool few = static_cast<int>(ends.size()) <= 1 + after.ends() / 64;
  if (!few) return replace_all(cells, drawdown(after));
  // Where the ends that did not change hang.
  const std::vector<int> picks = changed_rows(lifts(before), lift, shafts_of_others(after.threading, ends));
  CellRect rect;
  update_ends(cells, before, after, ends, rect);
  update_picks(cells, after, lift, picks, rect);
  return rect;
}

BitMatrix complement(const BitMatrix& cells) {
  BitMatrix out = cells;
  if (cells.words() == 0) return out;
  for (int r = 0; r < out.rows(); ++r) {
    for (uint64_t& word : out.row(r)) word = ~word;
    out.row(r).back() &= out.last_word_mask();
  }
  return out;
}

}  // namespace weftlight::draft
