// Ends that weave alike can hang on one shaft, picks that lift alike can be woven with one treadle: so the fewest
// are the distinct columns and rows of the drawdown. What is more than that is the weaver's numbering, which is
// kept: a shaft stays with the ends that weave as it did, and only what differs looks for another.

#include "draft/factor.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

#include "draft/drawdown.h"
#include "draft/row_labels.h"

namespace weftlight::draft {
namespace {

bool same_row(const BitMatrix& a, const BitMatrix& b, int row) {
  return a.cols() == b.cols() && std::ranges::equal(a.row(row), b.row(row));
}

std::vector<char> used_columns(const BitMatrix& m) {
  std::vector<char> used(static_cast<size_t>(m.cols()), 0);
  for (int r = 0; r < m.rows(); ++r) for_each_bit(m.row(r), [&](int c) { used[c] = 1; });
  return used;
}

std::string wanting(int needed, const char* what, int most) {
  return "this takes " + std::to_string(needed) + " " + what + ", and the loom has " + std::to_string(most);
}

// Two treadles that together lift a pick; -1 when there are none.
using Pair = std::pair<int, int>;
Pair pair_for(const BitMatrix& tieup, std::span<const uint64_t> lift) {
  std::vector<int> inside;
  for (int t = 0; t < tieup.rows(); ++t) {
    bool fits = tieup.first(t) >= 0;
    for (size_t w = 0; fits && w < lift.size(); ++w) fits = (tieup.row(t)[w] & ~lift[w]) == 0;
    if (fits) inside.push_back(t);
  }
  for (size_t i = 0; i < inside.size(); ++i)
    for (size_t k = i + 1; k < inside.size(); ++k) {
      bool whole = true;
      for (size_t w = 0; whole && w < lift.size(); ++w)
        whole = (tieup.row(inside[i])[w] | tieup.row(inside[k])[w]) == lift[w];
      if (whole) return {inside[i], inside[k]};
    }
  return {-1, -1};
}

// The picks of a treadled draft before its treadles are given out anew.
struct TreadleAssignment {
  std::vector<char> kept;   // the pick's lift and its row of the treadling stay
  std::vector<Pair> both;   // the two treadles that lift a changed pick
  std::vector<char> fixed;  // of each treadle: its ties may not change
};

TreadleAssignment treading_of(const Draft& d, const BitMatrix& now) {
  const auto picks = static_cast<size_t>(d.picks());
  TreadleAssignment t{std::vector<char>(picks, 0), std::vector<Pair>(picks, {-1, -1}),
                      std::vector<char>(static_cast<size_t>(d.treadles), 0)};
  const BitMatrix was = lifts(d);
  bool two_feet = false;
  for (int p = 0; p < d.picks(); ++p) {
    const int feet = d.treadling.count(p);
    two_feet |= feet > 1;
    t.kept[p] = (feet != 1 || now.first(p) < 0) && same_row(was, now, p);
    if (t.kept[p]) for_each_bit(d.treadling.row(p), [&](int treadle) { t.fixed[treadle] = 1; });
  }
  if (!two_feet || now.cols() != d.shafts) return t;
  const std::vector<int> first = first_equal_rows(now);
  for (int p = 0; p < d.picks(); ++p) {
    if (t.kept[p] || same_row(was, now, p) || now.first(p) < 0) continue;
    t.both[p] = t.both[first[p]].first >= 0 ? t.both[first[p]] : pair_for(d.tieup, now.row(p));
    if (t.both[p].first >= 0) t.fixed[t.both[p].first] = t.fixed[t.both[p].second] = 1;
  }
  return t;
}

Labelling treadles_of(const Draft& d, const TreadleAssignment& treadle_assignment, const BitMatrix& now) {
  std::vector<char> takes_part;
  for (int p = 0; p < d.picks(); ++p)
    takes_part.push_back(!treadle_assignment.kept[p] && treadle_assignment.both[p].first < 0 && now.first(p) >= 0);
  BitMatrix ties = d.tieup;
  ties.resize(d.treadles, now.cols());
  Labelling l = labelling_of(now, takes_part, ties);
  l.fixed = treadle_assignment.fixed;
  for (int p = 0; p < d.picks(); ++p)
    if (d.treadling.count(p) == 1) l.old_label[p] = d.treadling.first(p);
  for (int t = 0; t < d.treadles; ++t) l.empty[t] = ties.first(t) < 0;
  return l;
}

void tread(Draft& d, const Labelling& l, const TreadleAssignment& treadle_assignment, const BitMatrix& now) {
  const std::vector<char> used_before = used_columns(d.treadling);
  BitMatrix treadling(d.picks(), l.labels());
  for (int p = 0; p < d.picks(); ++p) {
    const auto on = [&](int treadle) { treadling.set(p, treadle, true); };
    if (treadle_assignment.kept[p]) {
      for_each_bit(d.treadling.row(p), on);
    } else if (treadle_assignment.both[p].first >= 0) {
      on(treadle_assignment.both[p].first);
      on(treadle_assignment.both[p].second);
    } else if (l.label(p) >= 0) {
      on(l.label(p));
    }
  }
  d.treadles = l.labels();
  d.treadling = std::move(treadling);
  d.tieup.resize(d.treadles, now.cols());
  const std::vector<char> used = used_columns(d.treadling);
  for (int t = 0; t < d.treadles; ++t) {
    const bool out_of_use = t < static_cast<int>(used_before.size()) && used_before[t] && !used[t];
    if (l.owner[t] >= 0) std::ranges::copy(now.row(l.first[l.owner[t]]), d.tieup.row(t).begin());
    else if (out_of_use) std::ranges::fill(d.tieup.row(t), 0);
  }
}

// Rows of the result: what each shaft weaves, one bit a pick, 1 where its ends are up.
BitMatrix shaft_columns(const Draft& d) {
  const BitMatrix named = transposed(lifts(d));
  return d.rising ? named : complement(named);
}

// What each shaft is to weave, as lifts. Shafts that nobody needs any more are lifted no more.
BitMatrix lifts_of(const Draft& like, const Labelling& l, const BitMatrix& columns, const BitMatrix& threading) {
  const std::vector<char> used_before = used_columns(like.threading), used = used_columns(threading);
  BitMatrix named = transposed(lifts(like));
  named.resize(l.labels(), like.picks());
  for (int s = 0; s < l.labels(); ++s) {
    if (l.owner[s] >= 0) {
      std::ranges::copy(columns.row(l.first[l.owner[s]]), named.row(s).begin());
      if (like.rising || named.words() == 0) continue;
      for (uint64_t& word : named.row(s)) word = ~word;
      named.row(s).back() &= named.last_word_mask();
    } else if (s < like.shafts && used_before[s] && !used[s]) {
      std::ranges::fill(named.row(s), 0);
    }
  }
  return transposed(named);
}

// Distinct rows and how many threads have each.
struct DistinctRows {
  std::vector<int> row;  // a row of each kind
  std::vector<int64_t> threads;
  std::vector<int> kind;  // of each row
};

DistinctRows distinct_rows_of(const BitMatrix& m) {
  DistinctRows k;
  const std::vector<int> first = first_equal_rows(m);
  std::vector<int> at(first.size(), -1);
  for (int r = 0; r < m.rows(); ++r) {
    if (first[r] == r) {
      at[r] = static_cast<int>(k.row.size());
      k.row.push_back(r);
      k.threads.push_back(0);
    }
    k.kind.push_back(at[first[r]]);
    ++k.threads[at[first[r]]];
  }
  return k;
}

// The rows with all but `most` kinds woven as the most like of the others: the kind that costs the fewest
// crossings goes first, again and again. Of very many kinds the commonest stay. The empty row is free of charge
// where `empty_is_free`.
BitMatrix with_fewer_kinds(BitMatrix m, int most, bool empty_is_free) {
  constexpr size_t kMany = 1024;
  DistinctRows k = distinct_rows_of(m);
  const auto is_free = [&](size_t kind) { return empty_is_free && m.first(k.row[kind]) < 0; };
  std::vector<size_t> alive;
  int counted = 0;
  for (size_t i = 0; i < k.row.size(); ++i) {
    alive.push_back(i);
    counted += !is_free(i);
  }
  std::vector<int> becomes(k.row.size());
  for (size_t i = 0; i < becomes.size(); ++i) becomes[i] = static_cast<int>(i);
  const auto nearest = [&](size_t kind) {
    std::pair<int, size_t> best{std::numeric_limits<int>::max(), kind};
    for (const size_t other : alive)
      if (other != kind) best = std::min(best, {differences(m.row(k.row[kind]), m.row(k.row[other])), other});
    return best;
  };
  if (alive.size() > kMany && counted > most) {
    std::ranges::stable_sort(alive, [&](size_t a, size_t b) { return k.threads[a] > k.threads[b]; });
    const std::vector<size_t> rest(alive.begin() + most, alive.end());
    alive.resize(static_cast<size_t>(most));
    for (const size_t kind : rest) becomes[kind] = static_cast<int>(nearest(kind).second);
    counted = most;
  }
  std::vector<std::pair<int, size_t>> to(k.row.size());
  if (counted > most)
    for (const size_t kind : alive) to[kind] = nearest(kind);
  while (counted > most && alive.size() > 1) {
    size_t least = alive.front();
    int64_t least_cost = std::numeric_limits<int64_t>::max();
    for (const size_t kind : alive) {
      const int64_t cost = k.threads[kind] * to[kind].first;
      if (is_free(kind) || cost >= least_cost) continue;
      least = kind;
      least_cost = cost;
    }
    std::erase(alive, least);
    becomes[least] = static_cast<int>(to[least].second);
    k.threads[to[least].second] += k.threads[least];
    for (const size_t kind : alive)
      if (to[kind].second == least) to[kind] = nearest(kind);
    --counted;
  }
  BitMatrix out = m;
  for (int r = 0; r < m.rows(); ++r) {
    int kind = k.kind[r];
    while (becomes[kind] != kind) kind = becomes[kind];
    std::ranges::copy(m.row(k.row[kind]), out.row(r).begin());
  }
  return out;
}

int distinct_rows(const BitMatrix& m, bool with_empty) {
  const std::vector<int> first = first_equal_rows(m);
  int kinds = 0;
  for (int r = 0; r < m.rows(); ++r) kinds += first[r] == r && (with_empty || m.first(r) >= 0);
  return kinds;
}

}  // namespace

Factored with_lifts(const Draft& like, const BitMatrix& now, int most_treadles) {
  Factored out{like, {}, 0, 0, 0};
  out.draft.shafts = now.cols();
  if (like.shafts != now.cols()) {
    out.draft.threading.resize(like.ends(), now.cols());
    out.draft.liftplan.resize(like.picks(), now.cols());
  }
  if (like.drive == ShedControl::kLiftplan) {
    out.draft.tieup.resize(like.treadles, now.cols());
    out.draft.liftplan = now;
    return out;
  }
  const TreadleAssignment treadle_assignment = treading_of(like, now);
  Labelling l = treadles_of(like, treadle_assignment, now);
  out.treadles = l.groups();
  if (give_labels(l, most_treadles)) {
    tread(out.draft, l, treadle_assignment, now);
  } else {
    out.draft = like;
    out.why = wanting(l.groups(), "treadles", most_treadles);
  }
  return out;
}

Factored with_drawdown(const Draft& like, const BitMatrix& cells, LoomSize most) {
  const BitMatrix columns = transposed(cells), was = transposed(drawdown(like));
  std::vector<char> takes_part, fixed(static_cast<size_t>(like.shafts), 0);
  for (int e = 0; e < like.ends(); ++e) {
    const bool keeps = like.threading.count(e) != 1 && same_row(columns, was, e);
    takes_part.push_back(!keeps);
    if (keeps) for_each_bit(like.threading.row(e), [&](int shaft) { fixed[shaft] = 1; });
  }
  Labelling l = labelling_of(columns, takes_part, shaft_columns(like));
  l.fixed = std::move(fixed);
  const std::vector<char> used = used_columns(like.threading);
  for (int s = 0; s < like.shafts; ++s) l.empty[s] = !used[s];
  for (int e = 0; e < like.ends(); ++e)
    if (like.threading.count(e) == 1) l.old_label[e] = like.threading.first(e);
  if (!give_labels(l, most.shafts)) return {like, wanting(l.groups(), "shafts", most.shafts), l.groups(), 0, 0};

  Draft next = like;
  next.shafts = l.labels();
  next.threading.resize(like.ends(), next.shafts);
  for (int e = 0; e < like.ends(); ++e) {
    if (!takes_part[e]) continue;
    std::ranges::fill(next.threading.row(e), 0);
    next.threading.set(e, l.label(e), true);
  }
  const BitMatrix named = lifts_of(like, l, columns, next.threading);
  next.tieup.resize(like.treadles, next.shafts);
  next.liftplan.resize(like.picks(), next.shafts);
  Factored out = with_lifts(next, named, most.treadles);
  out.shafts = l.groups();
  if (!out.done()) out.draft = like;
  return out;
}

namespace {

// The same size with every end on the first shaft and nothing tied: an end that never rises needs a heddle, too.
Draft without_numbers(const Draft& like) {
  Draft bare = like;
  bare.shafts = bare.treadles = 1;
  bare.threading = BitMatrix(like.ends(), 1);
  for (int e = 0; e < like.ends(); ++e) bare.threading.set(e, 0, true);
  bare.tieup = BitMatrix(1, 1);
  bare.treadling = BitMatrix(like.picks(), 1);
  bare.liftplan = BitMatrix(like.picks(), 1);
  return bare;
}

bool fits(const Draft& d, LoomSize most) {
  return d.shafts <= most.shafts && (d.drive == ShedControl::kLiftplan || d.treadles <= most.treadles);
}

}  // namespace

Factored within_loom(const Draft& like, LoomSize most) {
  if (fits(like, most)) return {like, {}, 0, 0, 0};
  const BitMatrix cells = drawdown(like);
  Factored out = with_drawdown(like, cells, most);
  if (out.done() && fits(out.draft, most)) return out;
  out = with_drawdown(without_numbers(like), cells, most);
  if (!out.done()) out.draft = like;
  return out;
}

Factored closest_drawdown(const Draft& like, const BitMatrix& cells, LoomSize most) {
  const Factored exact = with_drawdown(like, cells, most);
  if (exact.done() && fits(exact.draft, most)) return exact;
  // Where the weaver's own numbers stand in the way: without them.
  const Draft bare = without_numbers(like);
  Factored out = with_drawdown(bare, cells, most);
  const std::string why = exact.done() ? out.why : exact.why;
  if (!out.done()) {
    BitMatrix near = transposed(with_fewer_kinds(transposed(cells), std::max(most.shafts, 1), false));
    if (like.drive == ShedControl::kTreadling)
      near = with_fewer_kinds(std::move(near), std::max(most.treadles, 1), like.rising);
    out = with_drawdown(like, near, most);
    if (!out.done() || !fits(out.draft, most)) out = with_drawdown(bare, near, most);
  }
  const BitMatrix shown = drawdown(out.draft);
  for (int p = 0; p < cells.rows(); ++p) out.wrong += differences(shown.row(p), cells.row(p));
  out.why = why;
  out.shafts = exact.shafts;
  out.treadles = exact.treadles;
  return out;
}

LoomSize fewest_for(const BitMatrix& cells) {
  return {distinct_rows(transposed(cells), true), distinct_rows(cells, false)};
}

int treadles_needed(const Draft& draft) { return distinct_rows(lifts(draft), false); }

}  // namespace weftlight::draft
