#pragma once
// An edit that the loom cannot weave, kept until the next edit, and the closest weave to it.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/difference.h"
#include "base/progress.h"
#include "session/document/edit.h"

namespace weftlight::session {

using design::Design;
using draft::BitMatrix, draft::CellRect;

/// The weave that the loom can make and that is closest to the requested design.
struct ClosestWeave {
  std::shared_ptr<const Design> design;
  std::string why;               // why it differs: "this needs 9 shafts, but the loom has 8"
  bool is_there = false;         // the present design is already the closest
  int64_t wrong = 0;             // crossings that differ from the request
  BitMatrix differing;           // picks x ends: those crossings
  std::vector<CellRect> places;  // their bounding rectangles
};

struct RejectedEdit {
  uint64_t stroke = 0;                      // the gesture that was rejected, in whole or part; 0: a single edit
  std::shared_ptr<const Design> requested;  // everything it painted, as on a loom of any size
  std::shared_ptr<const ClosestWeave> closest = nullptr;  // null until computed
};

/// The rejected edit after `edit` of `before`, which `changed` it or did nothing. Earlier edits of the same gesture are
/// part of the request. An accepted edit of another gesture clears the rejection.
std::optional<RejectedEdit> refusal_after(std::optional<RejectedEdit> last, const Design& before, const Edit& edit,
                                          uint64_t stroke, bool changed);

/// Null if the request shows the same cloth as `now`. Takes up to seconds; of no use if it was asked to stop.
std::shared_ptr<const ClosestWeave> closest_weave_to(const Design& now, const Design& requested,
                                                     const base::TaskProgress& progress = {});

/// The requested design on a loom that is large enough.
Edit larger_loom_edit(const RejectedEdit& rejected_edit);

}  // namespace weftlight::session
