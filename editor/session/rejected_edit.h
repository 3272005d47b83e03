#pragma once
// What was painted and the loom cannot weave, kept until something else is done, and what comes nearest to it.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/difference.h"
#include "session/edit.h"
#include "session/names.h"

namespace weftlight::session {

/// The draft of the loom that is nearest to a wish.
struct ClosestWeave {
  std::shared_ptr<const Design> design;
  std::string why;               // why it is not the wish: "this takes 9 shafts, and the loom has 8"
  bool is_there = false;         // nothing is nearer than the design as it is
  int64_t wrong = 0;             // crossings that it shows otherwise
  BitMatrix differing;           // picks x ends: those
  std::vector<CellRect> places;  // where they are
};

struct RejectedEdit {
  uint64_t stroke = 0;                      // the gesture that was refused, in whole or in part; 0: one edit
  std::shared_ptr<const Design> requested;  // all that it painted, as on a loom of any size
  std::shared_ptr<const ClosestWeave> nearest = nullptr;  // null: not worked out yet
};

/// What is refused after an edit of `before`, which `changed` it or did nothing: what other edits of the same gesture
/// had done is part of the wish. An edit that was taken ends what was refused before it.
std::optional<RejectedEdit> refusal_after(std::optional<RejectedEdit> last, const Design& before, const Edit& edit,
                                          uint64_t stroke, bool changed);

/// Null: the wish shows the same cloth as `now`.
std::shared_ptr<const ClosestWeave> nearest_to(const Design& now, const Design& requested);

/// The wish itself, on a loom as large as it takes.
Edit larger_loom_edit(const RejectedEdit& rejected_edit);

}  // namespace weftlight::session
