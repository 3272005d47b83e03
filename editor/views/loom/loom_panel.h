#pragma once
// The loom: which pick is woven, what to press or to lift for it, in type that is read from across the room.

#include <string>

#include "session/at_loom.h"
#include "session/loom_link.h"
#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// What the window knows of the line to the loom.
struct LoomLine {
  LoomLink::State state = LoomLink::State::kOff;
  std::string why;  // it is not there
};

/// Fills what is left of the current ImGui window. `address`: as it is being typed.
void draw_loom(PanelContext& c, const LoomLine& line, std::string& address);

/// "Treadles 3 + 5", "Shafts 1 + 2 + 4", "Nothing": what the feet or hands do for a pick.
std::string press_text(const Draft& draft, int pick);

}  // namespace weftlight::views
