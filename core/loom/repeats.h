#pragma once
// Threads in groups that a weaver counts by: where a threading or a treadling repeats itself.

#include <span>
#include <string>
#include <vector>

namespace weftlight::loom {

/// Threads that are counted together.
struct ThreadGroup {
  int first = 0, count = 0;
  std::string name = {};  // of a named section; else empty
  bool operator==(const ThreadGroup&) const = default;
};

/// Longest repeat that is looked for, in threads, and how many threads without a repeat stay together.
inline constexpr int kLongestRepeat = 64, kMaxWithoutRepeat = 16;
/// A shorter repeat is counted several at a time.
inline constexpr int kMinGroup = 4;

/// Groups of a sequence, one after the other and together the whole of it. Equal numbers stand for equal threads. From
/// the left, the repeat that covers most threads from here on (of equals the shortest) becomes groups of its length;
/// threads that repeat nothing become groups of kMaxWithoutRepeat. A cut-off repeat at the end is a group of its own.
std::vector<ThreadGroup> groups_by_repeat(std::span<const int> sequence);

/// The place of a thread: counted from 0. `groups` are in order and cover it.
struct PlaceInGroups {
  int group = 0, thread = 0;  // `thread`: in its group
};
PlaceInGroups place_in(std::span<const ThreadGroup> groups, int thread);

}  // namespace weftlight::loom
