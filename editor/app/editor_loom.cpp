// Weaving at the loom: steps by key, by click or by request of the loom.

#include <algorithm>

#include "app/editor.h"
#include "views/loom/loom_panel.h"

namespace weftlight::app {

void Editor::toggle_loom() {
  AtLoom& at = view().at_loom;
  at.open = !at.open;
  at.session = ++sittings_;
  loom_address_ = settings_.loom_address;
  if (!at.open) loom_.disconnect();
}

void Editor::step_at_loom(bool forwards) {
  carry_out(step_by_hand(view().at_loom, document().now(), forwards, loom_.state() == LoomLink::State::kConnected));
}

void Editor::connect_loom() {
  loom_of_ = session_.active().id;
  loom_.connect(settings_.loom_address);
}

void Editor::disconnect_loom() { loom_.disconnect(); }

void Editor::carry_out(const LoomStep& step) {
  if (!step.send.empty()) loom_.send(step.send);
  if (step.edit) commit(*step.edit);
}

bool Editor::update_loom() {
  // The loom weaves the draft that it was connected with: another active draft disconnects it.
  if (loom_state_ != LoomLink::State::kOff && loom_of_ != session_.active().id) loom_.disconnect();
  const LoomLink::News news = loom_.take();
  if (news.connected) carry_out(greet(view().at_loom, document().now()));
  for (const loom::LoomReport& report : news.reports) carry_out(hear(view().at_loom, document().now(), report));
  const LoomLink::State state = loom_.state();
  std::string why = loom_.why();
  const bool other = state != loom_state_ || why != loom_why_;
  loom_state_ = state;
  loom_why_ = std::move(why);
  return other || news.connected || !news.reports.empty();
}

void Editor::draw_loom_window(PanelContext& c, const WindowLayout& l) {
  ImGui::SetNextWindowPos(l.draft.at);
  ImGui::SetNextWindowSize({std::max(1.0f, l.status.size.x), std::max(1.0f, l.draft.size.y)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::Begin("Loom", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNavFocus);
  ImGui::PopStyleVar();
  draw_loom(c, view().at_loom, {loom_state_, loom_why_}, loom_address_);
  ImGui::End();
}

}  // namespace weftlight::app
