#include "views/shell/history_window.h"

#include <algorithm>
#include <string>

#include "base/text.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {

using base::tr;
using design::History;
using session::Settings;
using ui::Colors, ui::blend, ui::fitted, ui::hit_area, ui::key_pressed, ui::with_alpha;

namespace {

constexpr float kWidth = 264, kHeight = 380, kRow = 26, kMargin = 22;  // pixels at 96 dpi

/// The mark of a step on the timeline, filled up to the current step.
void draw_knot(const PanelContext& c, ImVec2 at, float height, const History& h, size_t step) {
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const Colors& k = c.style.color;
  const bool current = step == h.position(), done = step <= h.position();
  const ImVec2 middle{at.x + c.style.px(10), at.y + height / 2};
  const ImU32 line = done ? with_alpha(k.accent, 0.55f) : k.line_strong;
  if (step > 0) dl->AddLine({middle.x, at.y}, middle, line, 1.5f);
  const ImU32 next = step < h.position() ? with_alpha(k.accent, 0.55f) : k.line_strong;
  if (step + 1 < h.steps()) dl->AddLine(middle, {middle.x, at.y + height}, next, 1.5f);
  const float r = c.style.px(current ? 5 : 3.5f);
  dl->AddCircleFilled(middle, r, done ? k.accent : k.raised);
  if (!done) dl->AddCircle(middle, r, k.line_strong, 0, 1.4f);
}

void draw_step(PanelContext& c, const Document& document, size_t step) {
  const History& h = document.history();
  const bool current = step == h.position();
  const float height = c.style.px(kRow), width = ImGui::GetContentRegionAvail().x;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(static_cast<int>(step));
  if (hit_area("step", {width, height}) && !current) c.wanted.go_to(step);
  const bool hovered = ImGui::IsItemHovered();
  ImGui::PopID();
  c.map.add_item("history:" + std::to_string(step));
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const Colors& k = c.style.color;
  if (current || hovered)
    dl->AddRectFilled(at, {at.x + width, at.y + height}, with_alpha(k.accent, current ? 0.16f : 0.08f), c.style.px(5));
  draw_knot(c, at, height, h, step);
  const char* saved = !document.path().empty() && h.is_saved(step) ? tr("saved") : "";
  const float note = ImGui::CalcTextSize(saved).x, left = c.style.px(kMargin), y = (height - ImGui::GetFontSize()) / 2;
  const std::string label = step == 0 ? tr("Start") : h.label(step);
  const std::string shown = fitted(label, width - left - note - c.style.px(16));
  const ImU32 color = step > h.position() ? with_alpha(k.muted, 0.75f)
                      : current           ? k.text
                                          : blend(k.text, k.muted, 0.35f);
  dl->AddText({at.x + left, at.y + y}, color, shown.c_str());
  dl->AddText({at.x + width - note - c.style.px(8), at.y + y}, k.muted, saved);
}

/// Keeps the current step visible when it changes.
void follow(const PanelContext& c, const History& h, HistoryWindow& window) {
  if (window.steps == h.steps() && window.position == h.position() && !ImGui::IsWindowAppearing()) return;
  window = {h.steps(), h.position()};
  const float row = c.style.px(kRow), room = ImGui::GetWindowHeight(), top = row * static_cast<float>(h.position());
  const float now = ImGui::GetScrollY();
  if (top < now || top + 2 * row > now + room) ImGui::SetScrollY(std::max(0.0f, top + row - 0.6f * room));
}

void draw_steps(PanelContext& c, const Document& document, HistoryWindow& window) {
  const History& h = document.history();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::BeginChild("steps");
  follow(c, h, window);
  ImGuiListClipper rows;
  rows.Begin(static_cast<int>(h.steps()), c.style.px(kRow));
  while (rows.Step())
    for (int row = rows.DisplayStart; row < rows.DisplayEnd; ++row) draw_step(c, document, static_cast<size_t>(row));
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace

void draw_history(PanelContext& c, const Document& document, HistoryWindow& window) {
  window.focused = false;
  if (!c.settings.show_history) return;
  const ImGuiViewport* view = ImGui::GetMainViewport();
  ImGui::SetNextWindowSize({c.style.px(kWidth), c.style.px(kHeight)}, ImGuiCond_Appearing);
  ImGui::SetNextWindowPos({view->WorkPos.x + view->WorkSize.x - c.style.px(336), view->WorkPos.y + c.style.px(56)},
                          ImGuiCond_Appearing, {1, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, c.style.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, c.style.color.raised);
  bool open = true;
  if (ImGui::Begin(tr("History"), &open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
    draw_steps(c, document, window);
    window.focused = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
    if (window.focused && key_pressed(ImGuiKey_Escape) && !c.frame.popup_closed) open = false;
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  if (!open) c.wanted.change_settings([](Settings& s) { s.show_history = false; });
}

}  // namespace weftlight::views
