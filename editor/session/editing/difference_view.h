#pragma once
// The crossings that the drawdown marks as different, and their list: from a draft that is compared, or from what was
// painted while the closest weave to it is previewed.

#include <memory>

#include "session/document/other_draft.h"
#include "session/document/rejected_edit.h"

namespace weftlight::session {

struct DifferenceView {
  std::shared_ptr<const OtherDraft> other;      // draft compared with; null if none
  std::shared_ptr<const ClosestWeave> closest;  // being previewed, its wrong crossings marked; null if none
  int place = -1;                               // difference last shown, an index; -1: none yet
};

}  // namespace weftlight::session
