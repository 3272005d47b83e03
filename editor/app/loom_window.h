#pragma once
// Weaving at the loom: steps by key, by click or by request of the loom.

#include <cstdint>
#include <string>

#include "actions/loom_actions.h"
#include "app/editing.h"
#include "session/files/user_files.h"
#include "session/loom/loom_link.h"
#include "session/session.h"
#include "views/shell/window_layout.h"

namespace weftlight::app {

using actions::LoomActions;
using session::AtLoom, session::LoomLink, session::LoomStep, session::Session, session::Settings;
using views::PanelContext, views::WindowLayout;

class LoomWindow {
 public:
  LoomWindow(Session& session, Editing& editing, const Settings& settings);
  void toggle();
  void step(bool forwards);
  void connect();
  void disconnect() { link_.disconnect(); }
  /// Handles reports of the loom; true if there is something to show.
  bool update();
  /// In place of draft and cloth.
  void draw(PanelContext& c, const WindowLayout& layout);

  LoomActions actions();

 private:
  void carry_out(const LoomStep& step);
  AtLoom& at_loom() { return editing_.view().at_loom; }

  Session& session_;
  Editing& editing_;
  const Settings& settings_;
  LoomLink link_;
  uint64_t weaves_ = 0;  // id of the document that the loom weaves
  std::string address_, why_;
  LoomLink::State state_ = LoomLink::State::kOff;  // as last shown
  uint64_t sittings_ = 0;                          // times that the view was shown or hidden
};

}  // namespace weftlight::app
