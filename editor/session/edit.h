#pragma once
// What changes a design: a function of it and the words that undo shows. Panels and actions make edits; the
// document alone commits them.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "draft/design.h"
#include "session/names.h"

namespace weftlight::session {

struct Edit {
  std::string label;
  std::function<Design(Design)> apply;
  uint64_t stroke = 0;  // edits with the same one are one step of undo; 0: those of one drag are
  std::function<std::string(const Design&)> why = {};  // why the design stays as it is, when it does
  bool by_painting = false;  // in the drawdown: shafts and treadles that it adds go again once they are out of use
  std::function<Design(Design)> anew = {};  // the same for another design, where `apply` is about one alone
};
using MaybeEdit = std::optional<Edit>;

}  // namespace weftlight::session
