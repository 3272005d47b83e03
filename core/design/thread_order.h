#pragma once
// Edits of whole threads: the ends or picks of a draft in a new order. Each moves with its threading (or treadling and
// liftplan) and, if `with_properties`, with its colour, yarn, spacing and thickness; otherwise these stay in place.

#include <span>
#include <vector>

#include "design/design.h"

namespace weftlight::design {

using draft::System;

/// Half-open range of ends or picks.
struct ThreadRange {
  System system = System::kWarp;
  int first = 0, end = 0;
  int count() const { return end - first; }
  bool operator==(const ThreadRange&) const = default;
};

/// A thread of the new order: an old thread, or (bare) one with its properties but on no shaft or treadle.
struct ThreadSource {
  int thread = 0;
  bool bare = false;
};

/// The draft with its ends or picks in a new order. Unchanged if a thread is out of range, or the result would have no
/// thread, more than kMaxThreads or more crossings than kMaxCells.
Design with_thread_order(Design design, System system, std::span<const ThreadSource> order, bool with_properties);

// Ranges are clipped to the threads; an empty range changes nothing.

/// Inserts `count` bare threads before `at`, with the properties of the thread there.
Design with_bare_threads(Design design, System system, int at, int count, bool with_properties = true);
/// A draft keeps at least one thread: a range of all threads changes nothing.
Design without_threads(Design design, const ThreadRange& range, bool with_properties = true);
/// Inserts a copy of the range after it. `mirrored`: reversed, without repeating the thread at the turn.
Design with_doubled_threads(Design design, const ThreadRange& range, bool mirrored, bool with_properties = true);
Design with_reversed_threads(Design design, const ThreadRange& range, bool with_properties = true);
/// The range rotated by `steps`: threads that leave at its end re-enter at its start.
Design with_rotated_threads(Design design, const ThreadRange& range, int steps, bool with_properties = true);

/// Extent of a repeat: from the range to the last thread, or over all threads, the range staying in place.
enum class RepeatExtent { kToEnd, kAll };
Design with_repeated_threads(Design design, const ThreadRange& range, RepeatExtent extent, bool with_properties = true);
/// Forwards and backwards in turn, the threads at the turns once (point draw).
Design with_point_repeat(Design design, const ThreadRange& range, RepeatExtent extent, bool with_properties = true);
/// As with_repeated_threads to the end, each repeat `step` shafts (treadles) further, cyclically.
Design with_advancing_repeat(Design design, const ThreadRange& range, int step, bool with_properties = true);

}  // namespace weftlight::design
