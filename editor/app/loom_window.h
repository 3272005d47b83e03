#pragma once
// At the loom: threading, sleying and weaving, in steps by key, by click, by request of the loom or of a phone.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "actions/loom_actions.h"
#include "app/editing.h"
#include "platform/own_addresses.h"
#include "session/files/user_files.h"
#include "session/loom/loom_link.h"
#include "session/loom/phone_link.h"
#include "session/loom/shown_step.h"
#include "session/loom/speaker.h"
#include "session/session.h"
#include "views/shell/window_layout.h"

namespace weftlight::app {

using actions::LoomActions;
using session::AtLoom, session::LoomGroups, session::LoomLink, session::LoomStep, session::LoomWork, session::PhoneLink,
    session::Session, session::Settings, session::ShownStep;
using views::PanelContext, views::WindowLayout;

class LoomWindow {
 public:
  LoomWindow(Session& session, Editing& editing, const Settings& settings);
  void toggle();
  void step(bool forwards);
  void connect();
  void disconnect() { link_.disconnect(); }
  /// Handles reports of the loom and steps of the phone; true if there is something to show.
  bool update();
  /// In place of draft and cloth.
  void draw(PanelContext& c, const WindowLayout& layout);

  LoomActions actions();

 private:
  void carry_out(const LoomStep& step);
  void give_tabby();
  /// Says the step that is shown, by a program of the system.
  void say_step();
  void say_new_step();
  void put_tabby_between();
  void open_page();
  bool update_link();
  bool update_page();
  /// Gives the page what the loom view shows.
  void show_on_page();
  ShownStep shown();
  bool connected() const { return link_.state() == LoomLink::State::kConnected; }
  AtLoom& at_loom() { return editing_.view().at_loom; }

  Session& session_;
  Editing& editing_;
  const Settings& settings_;
  LoomLink link_;
  PhoneLink phone_;
  session::Speaker speaker_;
  std::string said_;      // the words of the step that was shown last, while new steps are said
  uint64_t weaves_ = 0;   // id of the document that the loom weaves
  uint64_t page_of_ = 0;  // id of the document that the page shows
  std::string address_, why_;
  LoomLink::State state_ = LoomLink::State::kOff;  // as last shown
  std::vector<platform::OwnAddress> addresses_;    // of this machine, when the view was shown
  std::string page_address_ = "127.0.0.1", page_error_;
  PhoneLink::Status page_;  // as last shown
  uint64_t counted_revision_ = 0;
  std::optional<LoomGroups> groups_;  // of that revision, as the lifts are
  draft::BitMatrix lifts_;
  // What the picture on the page was drawn from, and the picture.
  std::optional<std::pair<uint64_t, loom::WeavingState>> pictured_;
  std::shared_ptr<const std::string> picture_;
};

}  // namespace weftlight::app
