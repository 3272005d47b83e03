#pragma once
// The draft that the open one is compared with.

#include <string>

#include "design/design.h"
#include "draft/drawdown.h"
#include "session/files/names.h"

namespace weftlight::session {

struct OtherDraft {
  std::string name;  // of its file
  Design design;
  BitMatrix cells;  // its drawdown
};

}  // namespace weftlight::session
