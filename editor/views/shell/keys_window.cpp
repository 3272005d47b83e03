#include <imgui.h>

#include <string>

#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/shell/action_list.h"

namespace weftlight::views {
namespace {

struct MouseHint {
  const char *what, *does;
};
constexpr MouseHint kPaintHints[] = {{"Drag", "paint; from a filled cell: clear"},
                                     {"Shift+drag", "keep the thread's other shafts or treadles"},
                                     {"Right drag", "clear"},
                                     {"Ctrl+drag", "select, without changing the tool"},
                                     {"Alt+click on a colour bar", "take that thread's colour and yarn in hand"}};
constexpr MouseHint kSelectHints[] = {{"Drag", "select a rectangle"},
                                      {"Shift+click", "extend it to there"},
                                      {"Drag inside", "move the marks"},
                                      {"Ctrl+drag inside", "copy them"},
                                      {"Right click", "everything that can be done with it"}};
constexpr MouseHint kViewHints[] = {{"Wheel, middle drag", "scroll the draft"},
                                    {"Ctrl+wheel", "larger or smaller cells"}};

void row(const PanelContext& c, const std::string& left, const std::string& right) {
  ImGui::TextUnformatted(left.c_str());
  ImGui::SameLine(c.style.px(210));
  muted_text(c, right);
}

void heading(const PanelContext& c, const char* text) {
  ImGui::Dummy({0, c.style.px(4)});
  push_font(c.style.font.bold);
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
}

void draw_keys(const PanelContext& c, std::span<const ActionItem> items) {
  std::string menu;
  for (const ActionItem& item : items) {
    if (item.shortcut.empty()) continue;
    const std::string own = item.menu.empty() ? "Selection" : item.menu;
    if (own != menu) heading(c, own.c_str());
    menu = own;
    row(c, item.shortcut, item.label);
  }
}

}  // namespace

void draw_keys_window(const PanelContext& c, std::span<const ActionItem> items, bool& open) {
  if (!open) return;
  const ImGuiViewport* view = ImGui::GetMainViewport();
  ImGui::SetNextWindowSize({c.style.px(540), c.style.px(560)}, ImGuiCond_Appearing);
  ImGui::SetNextWindowPos({view->WorkPos.x + view->WorkSize.x / 2, view->WorkPos.y + view->WorkSize.y / 2},
                          ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, c.style.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, c.style.color.raised);
  if (ImGui::Begin("Keys and mouse", &open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
    heading(c, "Mouse, paint tool");
    for (const MouseHint& hint : kPaintHints) row(c, hint.what, hint.does);
    heading(c, "Mouse, select tool");
    for (const MouseHint& hint : kSelectHints) row(c, hint.what, hint.does);
    heading(c, "Mouse, view");
    for (const MouseHint& hint : kViewHints) row(c, hint.what, hint.does);
    draw_keys(c, items);
    if (ImGui::IsWindowFocused() && key_pressed(ImGuiKey_Escape)) open = false;
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
}

}  // namespace weftlight::views
