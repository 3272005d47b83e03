// From lifts to the drawdown, one bit a crossing.
//
// A row is the OR of the rows of ends that hang on each named shaft. Picks with the same lift share one
// computed row. Where many lifts differ, eight shafts at a time are looked up in a table of the OR of
// every subset, over strips of ends narrow enough that the tables stay in the cache.
// Based on: V. L. Arlazarov, E. A. Dinic, M. A. Kronrod, I. A. Faradzev, "On economical construction of
// the transitive closure of a directed graph", 1970 (the method of four Russians).

#include "draft/drawdown.h"

#include <algorithm>
#include <array>
#include <bit>

namespace weftlight::draft {
namespace {

constexpr int kGroup = 8;  // shafts a table is indexed by
constexpr int kSubsets = 1 << kGroup;
constexpr int kTableWords = 2 * 1024 * 1024 / 8;  // all tables of a strip: within a level-3 cache
constexpr int kLine = 8;                          // words of a cache line

void or_into(uint64_t* to, const uint64_t* from, int words) {
  for (int w = 0; w < words; ++w) to[w] |= from[w];
}

bool same_words(std::span<const uint64_t> a, std::span<const uint64_t> b) {
  return std::equal(a.begin(), a.end(), b.begin());
}

// What the rows are made from: the ends of each shaft, and the ends that hang on any.
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

// Tables of one strip [word0, word0 + words): entry (group, subset) is the OR of the subset's shafts.
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

// The OR of one entry of each table. A cache line at a time stays in registers until all have been added.
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

bool tables_pay(const BitMatrix& lift, const std::vector<int>& picks) {
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
  if (tables_pay(lift, distinct)) {
    table_rows(cells, h, lift, distinct);
  } else {
    for (const int p : distinct) direct_row(h, lift.row(p), cells.row(p));
  }
  for (int p = 0; p < lift.rows(); ++p) {
    if (first[p] != p) std::copy_n(cells.row(first[p]).data(), cells.words(), cells.row(p).data());
  }
  return cells;
}

// Grows `rect` by a cell.
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

bool is_up(std::span<const uint64_t> shafts, std::span<const uint64_t> lift, bool rising) {
  bool on_shaft = false, named = false;
  for (size_t w = 0; w < shafts.size(); ++w) {
    on_shaft |= shafts[w] != 0;
    named |= (shafts[w] & lift[w]) != 0;
  }
  return on_shaft && named == rising;
}

std::vector<int> changed_rows(const BitMatrix& was, const BitMatrix& is) {
  std::vector<int> rows;
  for (int r = 0; r < is.rows(); ++r) {
    if (!same_words(was.row(r), is.row(r))) rows.push_back(r);
  }
  return rows;
}

void redo_picks(BitMatrix& cells, const Draft& draft, const BitMatrix& lift, const std::vector<int>& picks,
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

void redo_ends(BitMatrix& cells, const Draft& draft, const BitMatrix& lift, const std::vector<int>& ends,
               CellRect& rect) {
  for (const int e : ends) {
    for (int p = 0; p < cells.rows(); ++p) {
      const bool up = is_up(draft.threading.row(e), lift.row(p), draft.rising);
      if (cells.get(p, e) == up) continue;
      cells.set(p, e, up);
      include(rect, e, p);
    }
  }
}

}  // namespace

BitMatrix lifts(const Draft& draft) {
  if (draft.drive == ShedControl::kLiftplan) return draft.liftplan;
  BitMatrix out(draft.picks(), draft.shafts);
  for (int p = 0; p < draft.picks(); ++p) {
    for_each_bit(draft.treadling.row(p),
                 [&](int treadle) { or_into(out.row(p).data(), draft.tieup.row(treadle).data(), out.words()); });
  }
  return out;
}

BitMatrix drawdown(const Draft& draft) { return drawdown_of(make_harness(draft), lifts(draft), draft.ends()); }

CellRect update_drawdown(BitMatrix& cells, const Draft& before, const Draft& after) {
  const bool same_shape = before.ends() == after.ends() && before.picks() == after.picks() &&
                          before.shafts == after.shafts && cells.rows() == after.picks() &&
                          cells.cols() == after.ends();
  if (!same_shape || before.rising != after.rising) return replace_all(cells, drawdown(after));

  const BitMatrix lift = lifts(after);
  const std::vector<int> picks = changed_rows(lifts(before), lift);
  const std::vector<int> ends = changed_rows(before.threading, after.threading);
  // A changed end costs a visit to every row; past a share of the cloth the whole is cheaper.
  const bool few = static_cast<int>(ends.size()) <= 1 + after.ends() / 64;
  if (!few) return replace_all(cells, drawdown(after));
  CellRect rect;
  redo_ends(cells, after, lift, ends, rect);
  redo_picks(cells, after, lift, picks, rect);
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
