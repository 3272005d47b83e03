#pragma once
// The loom view: the current pick and what to press or lift for it, in type that can be read from across the room.

#include <string>

#include "session/loom/at_loom.h"
#include "session/loom/loom_link.h"
#include "views/common/panel.h"

namespace weftlight::views {

using draft::Draft;
using session::AtLoom, session::LoomLink;

/// State of the connection to the loom.
struct LoomLine {
  LoomLink::State state = LoomLink::State::kOff;
  std::string why;  // why it failed
};

/// Fills the rest of the current ImGui window. `address`: the text that is being typed.
void draw_loom(const PanelContext& c, const AtLoom& at_loom, const LoomLine& line, std::string& address);

/// What to press or lift for a pick: "Treadle 3 + 5", "Lift 1 + 2 + 4", "Lift nothing".
std::string press_text(const Draft& draft, int pick);

}  // namespace weftlight::views
