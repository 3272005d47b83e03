#pragma once
// The loom view: the current end, dent or pick and what to do for it, in type that can be read from across the room.

#include <string>
#include <vector>

#include "platform/own_addresses.h"
#include "session/loom/at_loom.h"
#include "session/loom/loom_link.h"
#include "session/loom/phone_link.h"
#include "session/loom/shown_step.h"
#include "views/common/panel.h"

namespace weftlight::views {

using draft::Draft;
using session::AtLoom, session::LoomLink, session::PhoneLink, session::ShownStep;

/// State of the connection to the loom.
struct LoomLine {
  LoomLink::State state = LoomLink::State::kOff;
  std::string why;  // why it failed
};

struct LoomView {
  const AtLoom& at_loom;
  ShownStep step;
  LoomLine line;
  const PhoneLink::Status& page;
  const std::string& page_error;                           // why there is none
  const std::vector<platform::OwnAddress>& own_addresses;  // where it can be
  bool can_speak = false;                                  // there is a program that does
};

/// Fills the rest of the current ImGui window. `address`: of the loom, the text that is being typed; `page_address`:
/// the one of this machine that is chosen for the page.
void draw_loom(const PanelContext& c, const LoomView& view, std::string& address, std::string& page_address);

}  // namespace weftlight::views
