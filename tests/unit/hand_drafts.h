#pragma once
// Drafts written by hand and drawdowns written as rows of text, pick 1 first, end 1 on the left, 1 where the
// warp is on top.

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "design/design.h"
#include "draft/drawdown.h"

namespace weftlight::design {

using draft::BitMatrix, draft::Draft, draft::ShedControl, draft::blank_draft;

using Rows = std::vector<std::string>;

inline Rows text_of(const BitMatrix& cells) {
  Rows rows;
  for (int p = 0; p < cells.rows(); ++p) {
    rows.emplace_back();
    for (int e = 0; e < cells.cols(); ++e) rows.back() += cells.get(p, e) ? '1' : '0';
  }
  return rows;
}

inline BitMatrix matrix_of(const Rows& rows) {
  BitMatrix m(static_cast<int>(rows.size()), rows.empty() ? 0 : static_cast<int>(rows[0].size()));
  for (int r = 0; r < m.rows(); ++r) {
    for (int c = 0; c < m.cols(); ++c) m.set(r, c, rows[r][c] == '1');
  }
  return m;
}

/// Each grid as rows of 0 and 1: threading by end, tie-up by treadle, treadling by pick.
inline Draft treadled(const Rows& threading, const Rows& tieup, const Rows& treadling) {
  const int shafts = static_cast<int>(threading[0].size()), treadles = static_cast<int>(tieup.size());
  Draft d = blank_draft(static_cast<int>(threading.size()), static_cast<int>(treadling.size()), shafts, treadles);
  d.threading = matrix_of(threading);
  d.tieup = matrix_of(tieup);
  d.treadling = matrix_of(treadling);
  return d;
}

/// A 2/2 twill, straight over four shafts and treadles.
inline Design straight_twill(int ends, int picks) {
  Design design;
  Draft& d = design.draft = blank_draft(ends, picks, 4, 4);
  for (int e = 0; e < ends; ++e) d.threading.set(e, e % 4, true);
  for (int p = 0; p < picks; ++p) d.treadling.set(p, p % 4, true);
  for (int t = 0; t < 4; ++t) d.tieup.set(t, t, true), d.tieup.set(t, (t + 1) % 4, true);
  return design;
}

/// The drawdown by its definition, crossing by crossing.
inline BitMatrix slow_drawdown(const Draft& d) {
  BitMatrix out(d.picks(), d.ends());
  for (int p = 0; p < d.picks(); ++p) {
    std::vector<bool> named(static_cast<size_t>(d.shafts), false);
    for (int s = 0; s < d.shafts; ++s) {
      if (d.shed_control == ShedControl::kLiftplan) named[s] = d.liftplan.get(p, s);
      for (int t = 0; d.shed_control == ShedControl::kTreadling && t < d.treadles; ++t) {
        if (d.treadling.get(p, t) && d.tieup.get(t, s)) named[s] = true;
      }
    }
    for (int e = 0; e < d.ends(); ++e) {
      bool threaded = false, pulled = false;
      for (int s = 0; s < d.shafts; ++s) {
        threaded |= d.threading.get(e, s);
        pulled |= d.threading.get(e, s) && named[s];
      }
      out.set(p, e, threaded && pulled == d.rising);
    }
  }
  return out;
}

inline void fill_randomly(BitMatrix& m, std::mt19937& random, double share) {
  std::bernoulli_distribution on(std::min(share, 1.0));
  for (int r = 0; r < m.rows(); ++r) {
    for (int c = 0; c < m.cols(); ++c) m.set(r, c, on(random));
  }
}

/// Some ends on several shafts, some on none; some picks with several treadles, some with none.
inline Draft random_draft(std::mt19937& random, int ends, int picks, int shafts, int treadles) {
  Draft d = blank_draft(ends, picks, shafts, treadles);
  fill_randomly(d.threading, random, 1.5 / shafts);
  fill_randomly(d.tieup, random, 0.5);
  fill_randomly(d.treadling, random, 1.5 / treadles);
  fill_randomly(d.liftplan, random, 0.5);
  d.rising = random() % 2 == 0;
  d.shed_control = random() % 2 == 0 ? ShedControl::kTreadling : ShedControl::kLiftplan;
  return d;
}

}  // namespace weftlight::design
