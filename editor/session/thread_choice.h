#pragma once
// The ends or picks that a weaver has chosen: what the Threads panel shows and edits. Pure values; the
// gestures that choose are in thread_labels.h.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "draft/design.h"
#include "session/names.h"

namespace weftlight::session {

struct ThreadChoice {
  System system = System::kWarp;
  std::vector<int> threads;  // ascending, each once; none: the whole warp or weft
  int anchor = -1;           // where a range begins
  // While a drag goes on: what was chosen before it, and whether its threads are added or taken away.
  std::vector<int> before;
  bool dragging = false, takes_away = false;
};

/// What a gesture does with what was chosen before.
enum class Choose { kOnly, kRange, kAlso };

/// A press on the head of a thread: that thread only; the range from the anchor to it; or also that one (or,
/// when it is chosen, no longer).
void begin_choice(ThreadChoice& choice, System system, int thread, Choose how);
/// The drag has come to another thread.
void drag_choice(ThreadChoice& choice, int thread);
/// Threads that are no more are not chosen.
void limit_choice(ThreadChoice& choice, const Draft& draft);

/// All threads that an edit concerns: the chosen ones, or every one of the system.
std::vector<int> concerned(const ThreadChoice& choice, const Draft& draft);
/// Every thread with the colour and yarn of any of these.
std::vector<int> threads_alike(const Draft& draft, System system, const std::vector<int>& threads);

/// "3-7, 12, 20-40/2" (every other one from 20 to 40); counted from 1.
std::string words_of_threads(const std::vector<int>& threads);
/// What such words name, in any order and with any blanks; none where a word cannot be read or names no
/// thread. "odd" and "even" are understood.
std::optional<std::vector<int>> threads_of_words(std::string_view words, int count);

/// What several threads have: one value, or several.
struct SharedIndex {
  int value = 0;            // of the first thread
  std::vector<int> others;  // further ones, by first use, at most seven
  bool mixed() const { return !others.empty(); }
};
struct SharedLength {
  float low = 0, high = 0;  // millimetres, in the cloth
  int own = 0;              // how many threads have one of their own rather than the yarn's
  bool mixed() const { return low != high; }
};
struct SharedThreads {
  int count = 0;
  SharedIndex color, yarn;
  SharedLength thickness, spacing;
};
SharedThreads shared_by(const Design& design, System system, const std::vector<int>& threads);

/// "end", "ends", "pick" or "picks".
const char* thread_word(System system, size_t count);
/// An edit of threads as undo tells it: "Thickness of 3 ends".
std::string thread_label(const std::string& what, System system, size_t count);

}  // namespace weftlight::session
