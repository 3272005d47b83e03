#pragma once
// Pure edits: Design -> Design. Each keeps the draft's invariants; an index out of range
// returns the design unchanged. The editor commits them to the History with a label.

#include <span>

#include "draft/design.h"
#include "draft/drawdown.h"

namespace weftlight::draft {

/// `only`: the thread is taken off its other shafts/treadles first (what a weaver expects of a click).
Design with_threading(Design design, int end, int shaft, bool on, bool only = true);
Design with_tieup(Design design, int treadle, int shaft, bool on);
Design with_treadling(Design design, int pick, int treadle, bool on, bool only = true);
/// Painting a liftplan of a treadled draft first turns it into a liftplan draft.
Design with_liftplan(Design design, int pick, int shaft, bool on);
/// A crossing as painted_cell (crossings.h) makes it; unchanged where the loom cannot.
Design with_drawdown_cell(Design design, int end, int pick, bool up);

Design with_thread_color(Design design, System system, int thread, int color);
Design with_thread_yarn(Design design, System system, int thread, int yarn);
Design with_thread_thickness(Design design, System system, int thread, float mm);
Design with_thread_spacing(Design design, System system, int thread, float mm);
/// The same for many threads at once; threads that are not there are left out.
Design with_thread_color(Design design, System system, std::span<const int> threads, int color);
Design with_thread_yarn(Design design, System system, std::span<const int> threads, int yarn);
Design with_thread_thickness(Design design, System system, std::span<const int> threads, float mm);
Design with_thread_spacing(Design design, System system, std::span<const int> threads, float mm);
Design with_palette_color(Design design, int color, Rgb rgb);
Design with_new_palette_color(Design design, Rgb rgb);
Design with_yarn(Design design, int yarn, const Yarn& value);
Design with_new_yarn(Design design, const Yarn& value);
/// New threads go on with the stripes of the old ones (colour, yarn, spacing, thickness); cells beyond are
/// empty. Counts are clamped to 1..kMax; more crossings than kMaxCells: unchanged.
Design with_size(Design design, int ends, int picks, int shafts, int treadles);
/// Turns the meaning of tie-up and liftplan; the faces change places.
Design with_rising(Design design, bool rising);

/// Same drawdown, driven by the liftplan; tie-up and treadling stay as they are.
Design to_liftplan(Design design);
/// Same drawdown, driven by treadles, one a pick. Treadles that it was driven by before keep their numbers where
/// their picks still lift alike; else the fewest, by first use. Unchanged when it is treadled so already, or when
/// more than `most_treadles` would be needed (treadles_needed in factor.h tells beforehand).
Design to_treadling(Design design, int most_treadles = kMaxShafts);
/// Same drawdown with a skeleton tie-up (skeleton.h): up to `feet` treadles a pick, fewer treadles in all.
Design to_skeleton(Design design, int feet);

}  // namespace weftlight::draft
