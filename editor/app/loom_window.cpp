#include "app/loom_window.h"

#include "app/fixed_window.h"
#include "app/window.h"
#include "views/loom/loom_panel.h"

namespace weftlight::app {

using session::greet, session::hear, session::step_by_hand;
using views::draw_loom;

LoomWindow::LoomWindow(Session& session, Editing& editing, const Settings& settings)
    : session_(session), editing_(editing), settings_(settings), link_(Window::wake) {}

void LoomWindow::toggle() {
  AtLoom& at = at_loom();
  at.open = !at.open;
  at.session = ++sittings_;
  address_ = settings_.loom_address;
  if (!at.open) link_.disconnect();
}

void LoomWindow::step(bool forwards) {
  carry_out(step_by_hand(at_loom(), editing_.document().now(), forwards, link_.state() == LoomLink::State::kConnected));
}

void LoomWindow::connect() {
  weaves_ = session_.active().id;
  link_.connect(settings_.loom_address);
}

void LoomWindow::carry_out(const LoomStep& step) {
  if (!step.send.empty()) link_.send(step.send);
  if (step.edit) editing_.commit(*step.edit);
}

bool LoomWindow::update() {
  // The loom weaves the draft that it was connected with: another active draft disconnects it.
  if (state_ != LoomLink::State::kOff && weaves_ != session_.active().id) link_.disconnect();
  const LoomLink::Received received = link_.take();
  if (received.connected) carry_out(greet(at_loom(), editing_.document().now()));
  for (const loom::LoomReport& report : received.reports) carry_out(hear(at_loom(), editing_.document().now(), report));
  const LoomLink::State state = link_.state();
  std::string why = link_.why();
  const bool other = state != state_ || why != why_;
  state_ = state;
  why_ = std::move(why);
  return other || received.connected || !received.reports.empty();
}

void LoomWindow::draw(PanelContext& c, const WindowLayout& l) {
  begin_fixed("Loom", {l.draft.at, {l.status.size.x, l.draft.size.y}}, {0, 0}, kFixed);
  draw_loom(c, at_loom(), {state_, why_}, address_);
  ImGui::End();
}

LoomActions LoomWindow::actions() {
  return {.toggle = [this] { toggle(); },
          .step = [this](bool forwards) { step(forwards); },
          .connect = [this] { connect(); },
          .disconnect = [this] { disconnect(); }};
}

}  // namespace weftlight::app
