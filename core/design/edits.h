#pragma once
// Pure edits: Design -> Design. Each keeps the draft's invariants; an index out of range
// returns the design unchanged. The editor commits them to the History with a label.

#include <cstdint>
#include <span>

#include "base/progress.h"
#include "design/design.h"
#include "draft/drawdown.h"

namespace weftlight::design {

using draft::Rgb, draft::kMaxShafts;

/// `only`: the thread is first removed from its other shafts or treadles, as a weaver expects of a click.
Design with_threading(Design design, int end, int shaft, bool on, bool only = true);
Design with_tieup(Design design, int treadle, int shaft, bool on);
Design with_treadling(Design design, int pick, int treadle, bool on, bool only = true);
/// Turns a draft with treadling into one with a liftplan first.
Design with_liftplan(Design design, int pick, int shaft, bool on);

Design with_thread_color(Design design, System system, int thread, int color);
Design with_thread_yarn(Design design, System system, int thread, int yarn);
Design with_thread_thickness(Design design, System system, int thread, float mm);
Design with_thread_spacing(Design design, System system, int thread, float mm);
/// The same for many threads; indices out of range are ignored.
Design with_thread_color(Design design, System system, std::span<const int> threads, int color);
Design with_thread_yarn(Design design, System system, std::span<const int> threads, int yarn);
Design with_thread_thickness(Design design, System system, std::span<const int> threads, float mm);
Design with_thread_spacing(Design design, System system, std::span<const int> threads, float mm);
Design with_palette_color(Design design, int color, Rgb rgb);
Design with_new_palette_color(Design design, Rgb rgb);
/// How the yarn is bought stays with it when it gets another name.
Design with_yarn(Design design, int yarn, const Yarn& value);
Design with_new_yarn(Design design, const Yarn& value);
/// New threads continue the stripes of the old ones (colour, yarn, spacing, thickness); new cells are empty. Counts are
/// clamped to their limits; with more than kMaxCells crossings the design is unchanged.
Design with_size(Design design, int ends, int picks, int shafts, int treadles);
/// What such a size takes from threads that stay: those that lose a shaft or treadle (in a liftplan, a lifted shaft),
/// and the marks of the tie-up.
struct SizeLoss {
  int ends = 0, picks = 0;
  int64_t tieup = 0;
  bool operator==(const SizeLoss&) const = default;
};
SizeLoss lost_by_size(const draft::Draft& d, int ends, int picks, int shafts, int treadles);
/// The plan of the cloth, every number within its limits.
Design with_plan(Design design, ClothPlan plan);
/// All threads of a system so much further apart, or closer, that there are `per_cm` of them in a cm, on average.
Design with_sett(Design design, System system, double per_cm);
/// Rising or sinking shed. The marks stay, so that front and back are exchanged.
Design with_rising(Design design, bool rising);

/// Same drawdown, shed control by the liftplan; tie-up and treadling are kept.
Design to_liftplan(Design design);
/// Same drawdown, shed control by tie-up and treadling, one treadle per pick. A treadle of the old treadling keeps its
/// number if its picks still have one lift; the others are the fewest possible, numbered by first use. Unchanged if the
/// draft is treadled so already, or needs more than `most_treadles` (treadles_needed in factor.h counts beforehand).
Design to_treadling(Design design, int most_treadles = kMaxShafts);
/// Same drawdown with a skeleton tie-up (skeleton.h): up to `treadles_per_pick` at once, fewer treadles in all. Takes
/// up to seconds.
Design to_skeleton(Design design, int treadles_per_pick, const base::TaskProgress& progress = {});

/// Sets what leads. With the liftplan, the liftplan is the shed control.
Design with_leading(Design design, Leading leading);
Design with_lock(Design design, bool locked);

}  // namespace weftlight::design
