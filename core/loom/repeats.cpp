#include "loom/repeats.h"

#include <algorithm>
#include <iterator>

namespace weftlight::loom {
namespace {

/// Threads from `at` on that repeat with this period, the first time included.
int repeated(std::span<const int> sequence, int at, int period) {
  const int size = static_cast<int>(sequence.size());
  int end = at + period;
  while (end < size && sequence[static_cast<size_t>(end)] == sequence[static_cast<size_t>(end - period)]) ++end;
  return std::min(end, size) - at;
}

struct Repeat {
  int period = 0, covers = 0;  // at least two whole repeats; 0: there is none
};

Repeat best_repeat(std::span<const int> sequence, int at) {
  Repeat best;
  const int left = static_cast<int>(sequence.size()) - at;
  for (int period = 1; period <= std::min(kLongestRepeat, left / 2); ++period) {
    int covers = repeated(sequence, at, period);
    if (covers < left) covers -= covers % period;  // only the end of the threads cuts a repeat off
    if (covers >= 2 * period && covers >= kMinGroup && covers > best.covers) best = {period, covers};
  }
  return best;
}

void add_groups(std::vector<ThreadGroup>& groups, int first, int threads, int of) {
  for (int done = 0; done < threads; done += of) groups.push_back({first + done, std::min(of, threads - done)});
}

/// Threads of a repeat as they are counted: one thread over and over by fours, "1 2" as "1 2 1 2".
int counted_length(int period) { return (kMinGroup + period - 1) / period * period; }

}  // namespace

std::vector<ThreadGroup> groups_by_repeat(std::span<const int> sequence) {
  const int size = static_cast<int>(sequence.size());
  std::vector<ThreadGroup> groups;
  int at = 0, single = 0;  // threads from `single` to `at` repeat nothing
  const auto end_singles = [&] { add_groups(groups, single, at - single, kMaxWithoutRepeat); };
  while (at < size) {
    const Repeat repeat = best_repeat(sequence, at);
    if (repeat.covers == 0) {
      ++at;
      continue;
    }
    end_singles();
    add_groups(groups, at, repeat.covers, counted_length(repeat.period));
    single = at += repeat.covers;
  }
  end_singles();
  return groups;
}

PlaceInGroups place_in(std::span<const ThreadGroup> groups, int thread) {
  const auto after = std::ranges::upper_bound(groups, thread, {}, [](const ThreadGroup& group) { return group.first; });
  if (after == groups.begin()) return {};
  const auto in = std::prev(after);
  return {static_cast<int>(in - groups.begin()), thread - in->first};
}

}  // namespace weftlight::loom
