#pragma once
// Edits of whole threads: a new order of the ends or picks of a draft, each with its threading (or its
// treadling and liftplan), and, `with_properties`, with its colour, yarn, spacing and thickness. Without, the
// stripes stay where they are and only the marks move.

#include <span>
#include <vector>

#include "draft/design.h"

namespace weftlight::draft {

/// Half-open range of ends or picks.
struct ThreadRange {
  System system = System::kWarp;
  int first = 0, end = 0;
  int count() const { return end - first; }
  bool operator==(const ThreadRange&) const = default;
};

/// A thread of the new order: an old one, or a bare one that only looks like it (on no shaft or treadle).
struct ThreadSource {
  int thread = 0;
  bool bare = false;
};

/// The draft with its ends or picks in a new order. Unchanged when that names a thread that is not there, or
/// would have no thread, more than kMaxThreads or more crossings than kMaxCells.
Design with_thread_order(Design design, System system, std::span<const ThreadSource> order, bool with_properties);

// Ranges reach no further than the threads there are; an empty one changes nothing.

/// `count` bare threads before `at`, which look like the thread there.
Design with_bare_threads(Design design, System system, int at, int count, bool with_properties = true);
/// The last thread stays: a range of all of them changes nothing.
Design without_threads(Design design, const ThreadRange& range, bool with_properties = true);
/// A copy of the range right after it; `mirrored`: backwards, and the thread at the turn only once.
Design with_doubled_threads(Design design, const ThreadRange& range, bool mirrored, bool with_properties = true);
Design with_reversed_threads(Design design, const ThreadRange& range, bool with_properties = true);
/// The range turned round by `steps`: what leaves at its end comes in at its beginning.
Design with_turned_threads(Design design, const ThreadRange& range, int steps, bool with_properties = true);

/// How far a repeat goes: from the range to the last thread, or over all threads with the range in its place.
enum class Reach { kToEnd, kAll };
Design with_repeated_threads(Design design, const ThreadRange& range, Reach reach, bool with_properties = true);
/// There and back again; the threads at both turns stand once (a point draw).
Design with_point_repeat(Design design, const ThreadRange& range, Reach reach, bool with_properties = true);
/// As with_repeated_threads to the end, each repeat `step` shafts (treadles) further, round and round.
Design with_advancing_repeat(Design design, const ThreadRange& range, int step, bool with_properties = true);

}  // namespace weftlight::draft
