#pragma once
// An edit: a function from design to design and the label of its undo step. Panels and actions make edits; only the
// document commits them.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "design/design.h"

namespace weftlight::session {

using design::Design;

struct Edit {
  std::string label;
  std::function<Design(Design)> apply;
  uint64_t stroke = 0;  // edits with the same number are one undo step; 0: the number of the current drag
  std::function<std::string(const Design&)> why = {};  // the reason if the design did not change
  bool by_painting = false;                 // in the drawdown: shafts and treadles that it adds are removed when unused
  std::function<Design(Design)> anew = {};  // the same for any design, if `apply` only fits one
};
using MaybeEdit = std::optional<Edit>;

/// An edit that takes seconds or minutes. It is computed beside the window, and committed unless the draft changed
/// meanwhile.
struct SlowEdit {
  std::string label;
  std::string doing;  // shown meanwhile: "Searching for a skeleton tie-up"
  std::function<base::Result<Design>(Design, const base::TaskProgress&)> apply;
  std::string no_change;  // said if the design did not change
  /// Where the draft changed meanwhile: what was made of `before`, as a change of the draft as it is now. Empty where
  /// the two do not agree; without it they never do.
  std::function<std::optional<Design>(Design now, const Design& before, const Design& made)> onto = {};
};

}  // namespace weftlight::session
