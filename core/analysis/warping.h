#pragma once
// What a weaver writes down before winding the warp: order of the colours, bouts, raddle groups, heddles; and whether
// the edges need floating selvedges.

#include <array>
#include <functional>
#include <vector>

#include "analysis/measures.h"

namespace weftlight::analysis {

using draft::BitMatrix, draft::Draft;

/// The fewest of n things after which they repeat, to the last of them; `same(a, b)`: a and b are alike.
int period_of(int n, const std::function<bool(int, int)>& same);

/// Neighbouring threads of one colour and yarn.
struct ThreadRun {
  int color = 0, yarn = 0;
  int64_t threads = 0;
  bool operator==(const ThreadRun&) const = default;
};
/// `repeat` as often as `times`, then `rest`.
struct ThreadOrder {
  std::vector<ThreadRun> repeat, rest;
  int64_t times = 0;
};
/// Colours and yarns of the first `threads` threads of the repeated draft.
ThreadOrder thread_order(const Design& design, System system, int64_t threads);

/// Heddles on each shaft for the first `ends` ends of the repeated draft, and ends on no shaft.
struct Heddles {
  std::vector<int64_t> on_shaft;
  int64_t unthreaded_ends = 0;
};
Heddles heddles_for(const Draft& draft, int64_t ends);

struct WarpingPlan {
  int64_t ends = 0;                     // to wind, with the floating selvedges
  int64_t bouts = 0, ends_in_bout = 0;  // ends of all bouts but the last
  int64_t ends_in_last = 0;
  int64_t raddle_groups = 0;
  std::vector<int> raddle;                   // ends in each group, repeated
  int64_t ends_in_last_group = 0;            // of the raddle
  int64_t whole_repeats = 0, more_ends = 0;  // of the draft across the cloth, and ends beyond them
};
WarpingPlan warping_plan(const Design& design, const ClothMeasures& measures);

/// How the weft binds one edge end where it turns around it: at every second pick, if the end changes its face there.
struct EdgeBinding {
  int64_t turns = 0, missed = 0;  // in a repeat of the picks
  int64_t unbound_picks = 0;      // most picks in a row that the weft passes without catching it; 0: none
  bool never() const { return turns > 0 && missed == turns; }
};
/// With one shuttle. By the end towards which the first pick goes: [0] towards the last end, [1] towards end 1.
struct Selvedges {
  struct Start {
    EdgeBinding first, last;  // of end 1, of the last end
    int64_t missed() const { return first.missed + last.missed; }
  };
  std::array<Start, 2> starts;
  /// The better direction of the first pick.
  int better() const { return starts[1].missed() < starts[0].missed() ? 1 : 0; }
  /// Neither direction binds both edges at every turn.
  bool floating_needed() const { return starts[0].missed() > 0 && starts[1].missed() > 0; }
  bool any_direction() const { return starts[0].missed() == 0 && starts[1].missed() == 0; }
};
/// `last_end`: index of the end at the other edge of the cloth, which may lie within the draft.
Selvedges selvedges(const BitMatrix& cells, int last_end);
/// Index in the draft of the last of `ends` ends of the repeated draft.
int last_end_of(const Draft& draft, int64_t ends);

}  // namespace weftlight::analysis
