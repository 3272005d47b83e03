#pragma once
// The draft that the open one is compared with.

#include <string>

#include "design/design.h"
#include "draft/drawdown.h"

namespace weftlight::session {

using design::Design;
using draft::BitMatrix;

struct OtherDraft {
  std::string name;  // of its file
  Design design;
  BitMatrix cells;  // its drawdown
};

}  // namespace weftlight::session
