#pragma once
// The draft that the shown one is compared with.

#include <functional>

#include "session/report.h"

namespace weftlight::actions {

using session::Report;

struct ComparisonActions {
  /// Asks for a draft to compare with.
  std::function<void()> choose_draft;
  /// The last report on the shown draft; null if there is none.
  std::function<const Report*()> report;
};

}  // namespace weftlight::actions
