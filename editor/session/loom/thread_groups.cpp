#include "session/loom/thread_groups.h"

#include "base/text.h"
#include "session/loom/at_loom.h"
#include "weaves/sections.h"

namespace weftlight::session {

using base::arg, base::fill, base::tr;
using design::Assembly;
using draft::BitMatrix, draft::ShedControl, draft::System, draft::first_equal_rows;
using weaves::OrderItem, weaves::Turn, weaves::assembled_threads, weaves::read_order;

namespace {

/// Adds the sections of the items, one after the other. What runs forth and back turns on threads that two sections
/// share, so it is counted as one.
void add_sections(const Assembly& assembly, const std::vector<OrderItem>& items, std::vector<ThreadGroup>& groups) {
  for (const OrderItem& item : items) {
    OrderItem once = item;
    const bool whole = item.turn == Turn::kForthAndBack;
    if (!whole) once.times = 1;
    const int count = assembled_threads(assembly, {once});
    for (int time = 0; time < (whole ? 1 : item.times) && groups.size() < draft::kMaxThreads; ++time) {
      const int first = groups.empty() ? 0 : groups.back().first + groups.back().count;
      if (item.section.empty() && item.turn == Turn::kForth) add_sections(assembly, item.items, groups);
      else if (count > 0) groups.push_back({first, count, item.section});
    }
  }
}

/// Empty if the threads are not as the order made them.
std::vector<ThreadGroup> assembled_groups(const Assembly& assembly, int threads) {
  const auto order = read_order(assembly.order);
  if (!order || order->empty() || assembled_threads(assembly, *order) != threads) return {};
  std::vector<ThreadGroup> groups;
  add_sections(assembly, *order, groups);
  const bool fits = !groups.empty() && groups.back().first + groups.back().count == threads;
  return fits ? groups : std::vector<ThreadGroup>();
}

/// `threads` numbers, repeating those of the rows.
std::vector<int> repeated_rows(const BitMatrix& rows, int threads) {
  std::vector<int> sequence = first_equal_rows(rows);
  const size_t once = sequence.size();
  if (once == 0) return {};
  sequence.resize(static_cast<size_t>(threads));
  for (size_t i = once; i < sequence.size(); ++i) sequence[i] = sequence[i - once];
  return sequence;
}

}  // namespace

std::vector<ThreadGroup> groups_of_ends(const Design& design) {
  const int ends = ends_on_loom(design);
  std::vector<ThreadGroup> groups = assembled_groups(design.warp_assembly, ends);
  return groups.empty() ? loom::groups_by_repeat(repeated_rows(design.draft.threading, ends)) : groups;
}

std::vector<ThreadGroup> groups_of_picks(const Design& design) {
  const int picks = design.draft.picks();
  std::vector<ThreadGroup> groups = assembled_groups(design.weft_assembly, picks);
  if (!groups.empty()) return groups;
  const bool lifted = design.draft.shed_control == ShedControl::kLiftplan;
  return loom::groups_by_repeat(repeated_rows(lifted ? design.draft.liftplan : design.draft.treadling, picks));
}

std::string group_text(const std::vector<ThreadGroup>& groups, System system, int thread) {
  if (groups.size() < 2) return {};
  const loom::PlaceInGroups place = loom::place_in(groups, thread);
  const ThreadGroup& group = groups[static_cast<size_t>(place.group)];
  const bool warp = system == System::kWarp;
  const char* named = warp ? tr("Section {section} of {sections} ({name}): end {thread} of {threads}")
                           : tr("Section {section} of {sections} ({name}): pick {thread} of {threads}");
  const char* bare = warp ? tr("Section {section} of {sections}: end {thread} of {threads}")
                          : tr("Section {section} of {sections}: pick {thread} of {threads}");
  return fill(group.name.empty() ? bare : named, arg("section", place.group + 1), arg("sections", groups.size()),
              arg("name", group.name), arg("thread", place.thread + 1), arg("threads", group.count));
}

}  // namespace weftlight::session
