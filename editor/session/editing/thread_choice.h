#pragma once
// The ends or picks chosen for the Threads panel. Values only; the mouse gestures are in thread_labels.h.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "design/design.h"

namespace weftlight::session {

using design::Design;
using draft::Draft, draft::System;

struct ThreadChoice {
  System system = System::kWarp;
  std::vector<int> threads;  // ascending and unique; empty means the whole warp or weft
  int anchor = -1;           // start of a range
  // During a drag: the choice before it, and whether its threads are removed instead of added.
  std::vector<int> before;
  bool dragging = false, takes_away = false;
};

/// How a gesture combines with the earlier choice.
enum class Choose { kOnly, kRange, kAlso };

/// A press on a thread label chooses only that thread, the range from the anchor to it, or toggles it.
void begin_choice(ThreadChoice& choice, System system, int thread, Choose how);
/// Extends the drag to another thread.
void drag_choice(ThreadChoice& choice, int thread);
/// Drops threads that no longer exist.
void limit_choice(ThreadChoice& choice, const Draft& draft);

/// The threads that an edit applies to: the chosen ones, or all of the system.
std::vector<int> concerned(const ThreadChoice& choice, const Draft& draft);
/// All threads with the same colour and yarn as any of these.
std::vector<int> threads_alike(const Draft& draft, System system, const std::vector<int>& threads);

/// "3-7, 12, 20-40/2" (every other one from 20 to 40); counted from 1.
std::string words_of_threads(const std::vector<int>& threads);
/// Parses such a list, in any order and with any blanks; also "odd" and "even". Empty if a word cannot be read or names
/// no thread.
std::optional<std::vector<int>> threads_of_words(std::string_view words, int count);

/// "120"; "e120" or "end 120", "p40" or "pick 40", also by the words of the user's language. The number is not checked
/// against a draft.
struct NamedThread {
  std::optional<System> system;
  int number = 0;  // from 1
};
std::optional<NamedThread> named_thread(std::string_view words);

/// A property shared by several threads: one value, or several.
struct SharedIndex {
  int value = 0;            // that of the first thread
  std::vector<int> others;  // further values in order of first use, at most seven
  bool mixed() const { return !others.empty(); }
};
struct SharedLength {
  float low = 0, high = 0;  // mm in the cloth
  int own = 0;              // number of threads with their own value instead of the yarn's
  bool mixed() const { return low != high; }
};
struct SharedThreads {
  int count = 0;
  SharedIndex color, yarn;
  SharedLength thickness, spacing;
};
SharedThreads shared_by(const Design& design, System system, const std::vector<int>& threads);

/// What an edit changes of its threads.
enum class ThreadProperty { kYarn, kColor, kThickness, kSpacing, kThicknessAndSpacing };
/// Undo label of an edit of threads: "Thickness of 3 ends".
std::string thread_label(ThreadProperty property, System system, size_t count);

}  // namespace weftlight::session
