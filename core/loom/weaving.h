#pragma once
// Weaving a draft at a loom: which pick is next, what is sent, and how no pick is lost when the connection breaks.

#include <string>
#include <vector>

#include "loom/protocol.h"

namespace weftlight::loom {

using draft::BitMatrix, draft::Draft;

/// The picks that are woven, repeated without end: all of them, or a section.
struct PickRange {
  int first = 0, end = 0;  // half-open; empty: the whole draft
};

/// A pick counts as woven when the loom asks for the next one. A pick that was sent but not confirmed is sent again
/// when the connection is made anew.
struct WeavingState {
  int next_pick = 0;     // woven next
  int64_t woven = 0;     // picks so far, less those that were unwoven
  bool weaving = true;   // false: unweaving
  bool waiting = false;  // its shafts were sent
  // A tabby pick comes before next_pick; it is, or the next one will be, the second of the two tabby sheds.
  bool at_tabby = false, second_tabby = false;
  // Of a loom that takes picks ahead: what it knows of next_pick.
  enum class Shed {
    kUnknown,  // nothing was sent
    kSent,     // its shafts were sent
    kFixed,    // they are fixed; its shed opens next, or is open
    kAhead,    // its shed is open, and the shafts of the pick after it were sent
  } shed = Shed::kUnknown;
  bool operator==(const WeavingState&) const = default;
};

/// The state after a pick of `range` was woven or unwoven. `tabby_between`: a tabby pick comes before each pattern
/// pick, by turns of either shed. Without it, a step back from a tabby pick leaves that out.
WeavingState advanced(WeavingState state, const PickRange& range, int picks, bool tabby_between = false);
/// The state with `pick` (clamped to `range`) next, no tabby before it, and nothing sent.
WeavingState moved_to_pick(WeavingState state, const PickRange& range, int picks, int pick);

/// The state after a message from the loom, and what to send back.
struct LoomReply {
  WeavingState state;
  std::string send;
  std::string remark;  // for the weaver; may be empty
};
struct WeavingSetup {
  const Draft& draft;
  const BitMatrix& lifts;  // of the draft
  PickRange range;
  Protocol protocol = Protocol::kPlain;
  bool tabby_between = false;
};
LoomReply reply_to(const WeavingSetup& weaving, const WeavingState& state, const LoomReport& report);
/// What to send after each new connection: the direction, and the shafts of a pick that was sent but not confirmed.
LoomReply on_connected(const WeavingSetup& weaving, const WeavingState& state);
/// The shafts of next_pick, for a loom that takes picks ahead, when the weaver went there; otherwise nothing.
LoomReply sent_again(const WeavingSetup& weaving, const WeavingState& state);
/// A step by key or click, as if the loom had asked: for a Toika or a treadle loom, which report nothing.
LoomReply step_by_hand(const WeavingSetup& weaving, const WeavingState& state, bool forwards);
/// A tabby pick now, before next_pick, which stays where it is. At a tabby pick, the other shed instead. A remark if
/// the threading has no tabby.
LoomReply insert_tabby(const WeavingSetup& weaving, const WeavingState& state, bool connected);

}  // namespace weftlight::loom
