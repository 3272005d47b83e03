// Ends that weave alike can share a shaft, and picks with equal lifts a treadle: the fewest shafts and treadles are the
// distinct columns and rows of the drawdown. Beyond that the weaver's numbering is kept: a shaft stays with the ends
// that weave as it did, and only the others get another shaft.

#include "draft/factor.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <utility>

#include "base/text.h"
#include "draft/drawdown.h"
#include "draft/row_labels.h"

namespace weftlight::draft {

using base::arg, base::fill, base::tr_n;

namespace {

bool same_row(const BitMatrix& a, const BitMatrix& b, int row) {
  return a.cols() == b.cols() && std::ranges::equal(a.row(row), b.row(row));
}

std::vector<char> used_columns(const BitMatrix& m) {
  std::vector<char> used(static_cast<size_t>(m.cols()), 0);
  for (int r = 0; r < m.rows(); ++r) for_each_bit(m.row(r), [&](int c) { used[c] = 1; });
  return used;
}

base::Failure too_few_shafts(int needed, int most) {
  return base::failure(base::ErrorKind::kInput,
                       fill(tr_n("this needs {needed} shaft, but the loom has {most}",
                                 "this needs {needed} shafts, but the loom has {most}", needed),
                            arg("needed", needed), arg("most", most)));
}

base::Failure too_few_treadles(int needed, int most) {
  return base::failure(base::ErrorKind::kInput,
                       fill(tr_n("this needs {needed} treadle, but the loom has {most}",
                                 "this needs {needed} treadles, but the loom has {most}", needed),
                            arg("needed", needed), arg("most", most)));
}

// Two treadles whose union is the lift; -1, -1 if there are none.
using TreadlePair = std::pair<int, int>;
TreadlePair treadle_pair_for(const BitMatrix& tieup, std::span<const uint64_t> lift) {
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

// What stays when treadles are assigned anew.
struct TreadlingConstraints {
  std::vector<char> kept;         // of each pick: its row of the treadling stays
  std::vector<TreadlePair> pair;  // of each changed pick: two treadles that lift it, or -1
  std::vector<char> fixed;        // of each treadle: its ties may not change
};

TreadlingConstraints constraints_of(const Draft& d, const BitMatrix& now) {
  const auto picks = static_cast<size_t>(d.picks());
  TreadlingConstraints t{std::vector<char>(picks, 0), std::vector<TreadlePair>(picks, {-1, -1}),
                         std::vector<char>(static_cast<size_t>(d.treadles), 0)};
  const BitMatrix was = lifts(d);
  bool several_treadles = false;
  for (int p = 0; p < d.picks(); ++p) {
    const int treadles = d.treadling.count(p);
    several_treadles |= treadles > 1;
    t.kept[p] = (treadles != 1 || now.first(p) < 0) && same_row(was, now, p);
    if (t.kept[p]) for_each_bit(d.treadling.row(p), [&](int treadle) { t.fixed[treadle] = 1; });
  }
  if (!several_treadles || now.cols() != d.shafts) return t;
  const std::vector<int> first = first_equal_rows(now);
  for (int p = 0; p < d.picks(); ++p) {
    if (t.kept[p] || same_row(was, now, p) || now.first(p) < 0) continue;
    t.pair[p] = t.pair[first[p]].first >= 0 ? t.pair[first[p]] : treadle_pair_for(d.tieup, now.row(p));
    if (t.pair[p].first >= 0) t.fixed[t.pair[p].first] = t.fixed[t.pair[p].second] = 1;
  }
  return t;
}

Labelling treadle_labels(const Draft& d, const TreadlingConstraints& constraints, const BitMatrix& now) {
  std::vector<char> takes_part;
  for (int p = 0; p < d.picks(); ++p)
    takes_part.push_back(!constraints.kept[p] && constraints.pair[p].first < 0 && now.first(p) >= 0);
  BitMatrix ties = d.tieup;
  ties.resize(d.treadles, now.cols());
  std::vector<int> own(takes_part.size());
  std::iota(own.begin(), own.end(), 0);
  Labelling l = labelling_of(now, own, takes_part, ties);
  l.fixed = constraints.fixed;
  for (int p = 0; p < d.picks(); ++p)
    if (d.treadling.count(p) == 1) l.old_label[p] = d.treadling.first(p);
  for (int t = 0; t < d.treadles; ++t) l.empty[t] = ties.first(t) < 0;
  return l;
}

void assign_treadles(Draft& d, const Labelling& l, const TreadlingConstraints& constraints, const BitMatrix& now) {
  const std::vector<char> used_before = used_columns(d.treadling);
  BitMatrix treadling(d.picks(), l.labels());
  for (int p = 0; p < d.picks(); ++p) {
    const auto on = [&](int treadle) { treadling.set(p, treadle, true); };
    if (constraints.kept[p]) {
      for_each_bit(d.treadling.row(p), on);
    } else if (constraints.pair[p].first >= 0) {
      on(constraints.pair[p].first);
      on(constraints.pair[p].second);
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

// shafts x picks: 1 where the ends of the shaft are up.
BitMatrix shaft_columns(const Draft& d) {
  const BitMatrix named = transposed(lifts(d));
  return d.rising ? named : complement(named);
}

// The columns of a drawdown. Ends with the same shafts have theirs in common.
struct Columns {
  BitMatrix shared;          // x picks; some may be equal
  std::vector<int> of_end;   // row of `shared`
  std::vector<char> is_new;  // of each end
  std::span<const uint64_t> of(int end) const { return shared.row(of_end[end]); }
};

// The columns of `base`, with others for some ends.
Columns columns_of(const Draft& base, const std::vector<int>& ends, const BitMatrix& others) {
  Columns c;
  std::vector<int> kept;  // one of the ends that share a column
  const std::vector<int> first = first_equal_rows(base.threading);
  for (int e = 0; e < base.ends(); ++e) {
    c.of_end.push_back(first[e] == e ? static_cast<int>(kept.size()) : c.of_end[first[e]]);
    if (first[e] == e) kept.push_back(e);
  }
  c.shared = drawdown_columns(base, kept);
  c.is_new.assign(c.of_end.size(), 0);
  for (size_t i = 0; i < ends.size(); ++i)
    c.is_new[ends[i]] = !std::ranges::equal(c.of(ends[i]), others.row(static_cast<int>(i)));
  int at = c.shared.rows();
  c.shared.resize(at + static_cast<int>(std::ranges::count(c.is_new, 1)), base.picks());
  for (size_t i = 0; i < ends.size(); ++i) {
    if (!c.is_new[ends[i]]) continue;
    std::ranges::copy(others.row(static_cast<int>(i)), c.shared.row(at).begin());
    c.of_end[ends[i]] = at++;
  }
  return c;
}

// Lifts of the labelled shafts. Shafts that no end uses any more are not lifted.
BitMatrix lifts_of(const Draft& base, const Labelling& l, const Columns& columns, const BitMatrix& threading) {
  const std::vector<char> used_before = used_columns(base.threading), used = used_columns(threading);
  BitMatrix named = transposed(lifts(base));
  named.resize(l.labels(), base.picks());
  for (int s = 0; s < l.labels(); ++s) {
    if (l.owner[s] >= 0) {
      std::ranges::copy(columns.of(l.first[l.owner[s]]), named.row(s).begin());
      if (base.rising || named.words() == 0) continue;
      for (uint64_t& word : named.row(s)) word = ~word;
      named.row(s).back() &= named.last_word_mask();
    } else if (s < base.shafts && used_before[s] && !used[s]) {
      std::ranges::fill(named.row(s), 0);
    }
  }
  return transposed(named);
}

// The distinct rows of a matrix. Vectors are indexed by distinct row, but for `index`.
struct DistinctRows {
  std::vector<int> first;      // first row of that content
  std::vector<int64_t> count;  // equal rows
  std::vector<int> index;      // of each row of the matrix: its distinct row
};

DistinctRows distinct_rows_of(const BitMatrix& m) {
  DistinctRows d;
  const std::vector<int> first = first_equal_rows(m);
  std::vector<int> at(first.size(), -1);
  for (int r = 0; r < m.rows(); ++r) {
    if (first[r] == r) {
      at[r] = static_cast<int>(d.first.size());
      d.first.push_back(r);
      d.count.push_back(0);
    }
    d.index.push_back(at[first[r]]);
    ++d.count[at[first[r]]];
  }
  return d;
}

// The matrix with at most `most` distinct rows. Repeatedly the distinct row that costs the fewest cells is replaced by
// the most similar other one; of more than kMany distinct rows the most frequent are kept instead. The empty row does
// not count if `empty_is_free`. Asked to stop, it returns early, with more rows.
BitMatrix with_fewer_rows(BitMatrix m, int most, bool empty_is_free, const base::TaskProgress& progress) {
  constexpr size_t kMany = 1024;
  DistinctRows d = distinct_rows_of(m);
  const auto is_free = [&](size_t i) { return empty_is_free && m.first(d.first[i]) < 0; };
  std::vector<size_t> kept;
  int counted = 0;
  for (size_t i = 0; i < d.first.size(); ++i) {
    kept.push_back(i);
    counted += !is_free(i);
  }
  std::vector<int> becomes(d.first.size());
  for (size_t i = 0; i < becomes.size(); ++i) becomes[i] = static_cast<int>(i);
  const auto closest = [&](size_t i) {
    std::pair<int, size_t> best{std::numeric_limits<int>::max(), i};
    for (const size_t other : kept)
      if (other != i) best = std::min(best, {differences(m.row(d.first[i]), m.row(d.first[other])), other});
    return best;
  };
  if (kept.size() > kMany && counted > most) {
    std::ranges::stable_sort(kept, [&](size_t a, size_t b) { return d.count[a] > d.count[b]; });
    const std::vector<size_t> rest(kept.begin() + most, kept.end());
    kept.resize(static_cast<size_t>(most));
    for (const size_t i : rest) {
      if (progress.stopped()) return m;
      becomes[i] = static_cast<int>(closest(i).second);
    }
    counted = most;
  }
  std::vector<std::pair<int, size_t>> to(d.first.size());
  if (counted > most)
    for (const size_t i : kept) {
      if (progress.stopped()) return m;
      to[i] = closest(i);
    }
  const int excess = std::max(counted - most, 1);
  while (counted > most && kept.size() > 1) {
    if (progress.stopped()) return m;
    progress.report(1 - static_cast<float>(counted - most) / static_cast<float>(excess));
    size_t least = kept.front();
    int64_t least_cost = std::numeric_limits<int64_t>::max();
    for (const size_t i : kept) {
      const int64_t cost = d.count[i] * to[i].first;
      if (is_free(i) || cost >= least_cost) continue;
      least = i;
      least_cost = cost;
    }
    std::erase(kept, least);
    becomes[least] = static_cast<int>(to[least].second);
    d.count[to[least].second] += d.count[least];
    for (const size_t i : kept)
      if (to[i].second == least) to[i] = closest(i);
    --counted;
  }
  BitMatrix out = m;
  for (int r = 0; r < m.rows(); ++r) {
    int i = d.index[r];
    while (becomes[i] != i) i = becomes[i];
    std::ranges::copy(m.row(d.first[i]), out.row(r).begin());
  }
  return out;
}

int distinct_rows(const BitMatrix& m, bool with_empty) {
  const std::vector<int> first = first_equal_rows(m);
  int distinct = 0;
  for (int r = 0; r < m.rows(); ++r) distinct += first[r] == r && (with_empty || m.first(r) >= 0);
  return distinct;
}

}  // namespace

base::Result<void> fits(const Draft& d, LoomSize most) {
  if (d.shafts > most.shafts) return too_few_shafts(d.shafts, most.shafts);
  if (d.shed_control == ShedControl::kTreadling && d.treadles > most.treadles)
    return too_few_treadles(d.treadles, most.treadles);
  return {};
}

base::Result<Draft> with_lifts(const Draft& base, const BitMatrix& now, int most_treadles) {
  Draft out = base;
  out.shafts = now.cols();
  if (base.shafts != now.cols()) {
    out.threading.resize(base.ends(), now.cols());
    out.liftplan.resize(base.picks(), now.cols());
  }
  if (base.shed_control == ShedControl::kLiftplan) {
    out.tieup.resize(base.treadles, now.cols());
    out.liftplan = now;
    return out;
  }
  const TreadlingConstraints constraints = constraints_of(base, now);
  Labelling l = treadle_labels(base, constraints, now);
  if (!assign_labels(l, most_treadles)) return too_few_treadles(l.groups(), most_treadles);
  assign_treadles(out, l, constraints, now);
  return out;
}

namespace {

Labelling shaft_labels(const Draft& base, const Columns& columns, const std::vector<char>& takes_part) {
  Labelling l = labelling_of(columns.shared, columns.of_end, takes_part, shaft_columns(base));
  for (int e = 0; e < base.ends(); ++e)
    if (!takes_part[e]) for_each_bit(base.threading.row(e), [&](int shaft) { l.fixed[shaft] = 1; });
  const std::vector<char> used = used_columns(base.threading);
  for (int s = 0; s < base.shafts; ++s) l.empty[s] = !used[s];
  for (int e = 0; e < base.ends(); ++e)
    if (base.threading.count(e) == 1) l.old_label[e] = base.threading.first(e);
  return l;
}

}  // namespace

base::Result<Draft> with_drawdown(const Draft& base, const BitMatrix& cells, LoomSize most) {
  std::vector<int> all(static_cast<size_t>(base.ends()));
  std::iota(all.begin(), all.end(), 0);
  return with_columns(base, all, transposed(cells), most);
}

base::Result<Draft> with_columns(const Draft& base, const std::vector<int>& ends, const BitMatrix& others,
                                 LoomSize most) {
  const Columns columns = columns_of(base, ends, others);
  std::vector<char> takes_part;
  for (int e = 0; e < base.ends(); ++e) takes_part.push_back(base.threading.count(e) == 1 || columns.is_new[e]);
  Labelling l = shaft_labels(base, columns, takes_part);
  if (!assign_labels(l, most.shafts)) return too_few_shafts(l.groups(), most.shafts);

  Draft next = base;
  next.shafts = l.labels();
  next.threading.resize(base.ends(), next.shafts);
  for (int e = 0; e < base.ends(); ++e) {
    if (!takes_part[e]) continue;
    std::ranges::fill(next.threading.row(e), 0);
    next.threading.set(e, l.label(e), true);
  }
  const BitMatrix named = lifts_of(base, l, columns, next.threading);
  next.tieup.resize(base.treadles, next.shafts);
  next.liftplan.resize(base.picks(), next.shafts);
  return with_lifts(next, named, most.treadles);
}

namespace {

// A draft of the same size with every end on shaft 1 and no ties, so that no numbering is kept. An end that never rises
// needs a heddle, too.
Draft without_numbering(const Draft& base) {
  Draft bare = base;
  bare.shafts = bare.treadles = 1;
  bare.threading = BitMatrix(base.ends(), 1);
  for (int e = 0; e < base.ends(); ++e) bare.threading.set(e, 0, true);
  bare.tieup = BitMatrix(1, 1);
  bare.treadling = BitMatrix(base.picks(), 1);
  bare.liftplan = BitMatrix(base.picks(), 1);
  return bare;
}

}  // namespace

base::Result<Draft> within_loom(const Draft& base, LoomSize most) {
  if (fits(base, most)) return base;
  const BitMatrix cells = drawdown(base);
  base::Result<Draft> out = with_drawdown(base, cells, most);
  if (out && fits(*out, most)) return out;
  return with_drawdown(without_numbering(base), cells, most);
}

ClosestDraft closest_drawdown(const Draft& base, const BitMatrix& cells, LoomSize most,
                              const base::TaskProgress& progress) {
  base::Result<Draft> kept = with_drawdown(base, cells, most);
  if (kept && fits(*kept, most)) return {std::move(*kept), {}};
  // The weaver's numbering may not fit: try without it.
  const Draft bare = without_numbering(base);
  base::Result<Draft> out = with_drawdown(bare, cells, most);
  ClosestDraft closest{base, {}};
  if (!kept) closest.exact = failed(kept);
  else if (!out) closest.exact = failed(out);
  if (!out) {
    BitMatrix near = transposed(with_fewer_rows(transposed(cells), std::max(most.shafts, 1), false, progress));
    if (base.shed_control == ShedControl::kTreadling)
      near = with_fewer_rows(std::move(near), std::max(most.treadles, 1), base.rising, progress);
    if (progress.stopped()) return closest;
    out = with_drawdown(base, near, most);
    if (!out || !fits(*out, most)) out = with_drawdown(bare, near, most);
  }
  closest.draft = out ? *out : bare;
  const BitMatrix shown = drawdown(closest.draft);
  for (int p = 0; p < cells.rows(); ++p) closest.wrong += differences(shown.row(p), cells.row(p));
  return closest;
}

namespace {

/// Shafts with an end, or that something lifts.
std::vector<char> shafts_in_use(const Draft& d) {
  std::vector<char> used = used_columns(d.threading);
  for (const BitMatrix* by_shaft : {&d.tieup, &d.liftplan})
    for (int row = 0; row < by_shaft->rows(); ++row)
      for_each_bit(by_shaft->row(row), [&](int shaft) { used[shaft] = 1; });
  return used;
}

/// Treadles of a pick, or with a tie.
std::vector<char> treadles_in_use(const Draft& d) {
  std::vector<char> used = used_columns(d.treadling);
  for (int t = 0; t < d.treadles; ++t) used[t] |= static_cast<char>(d.tieup.first(t) >= 0);
  return used;
}

// All but those from `given` on that are in use no more, or never were.
std::vector<int> staying(const std::vector<char>& before, const std::vector<char>& now, int given) {
  std::vector<int> stay;
  for (int i = 0; i < static_cast<int>(now.size()); ++i) {
    const bool was_spare = i < static_cast<int>(before.size()) && !before[i];
    if (now[i] || i < given || was_spare) stay.push_back(i);
  }
  return stay;
}

BitMatrix chosen_rows(const BitMatrix& m, const std::vector<int>& rows) {
  BitMatrix out(static_cast<int>(rows.size()), m.cols());
  for (int row = 0; row < out.rows(); ++row) std::ranges::copy(m.row(rows[row]), out.row(row).begin());
  return out;
}

BitMatrix chosen_columns(const BitMatrix& m, const std::vector<int>& columns) {
  return transposed(chosen_rows(transposed(m), columns));
}

}  // namespace

Draft without_spare(Draft d, const Draft& before, LoomSize given) {
  const std::vector<int> shafts = staying(shafts_in_use(before), shafts_in_use(d), given.shafts);
  const std::vector<int> treadles = staying(treadles_in_use(before), treadles_in_use(d), given.treadles);
  if (static_cast<int>(shafts.size()) < d.shafts) {
    for (BitMatrix* by_shaft : {&d.threading, &d.tieup, &d.liftplan}) *by_shaft = chosen_columns(*by_shaft, shafts);
    d.shafts = static_cast<int>(shafts.size());
  }
  if (static_cast<int>(treadles.size()) < d.treadles) {
    d.tieup = chosen_rows(d.tieup, treadles);
    d.treadling = chosen_columns(d.treadling, treadles);
    d.treadles = static_cast<int>(treadles.size());
  }
  return d;
}

LoomSize fewest_for(const BitMatrix& cells) {
  return {distinct_rows(transposed(cells), true), distinct_rows(cells, false)};
}

int treadles_needed(const Draft& draft) { return distinct_rows(lifts(draft), false); }

}  // namespace weftlight::draft
