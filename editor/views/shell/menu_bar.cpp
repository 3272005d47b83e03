#include <algorithm>
#include <utility>
#include <vector>

#include "base/text.h"
#include "session/shown_keys.h"
#include "ui/icons.h"
#include "ui/imgui_compat.h"
#include "ui/keyboard.h"
#include "ui/widgets.h"
#include "views/shell/action_list.h"

namespace weftlight::views {

using base::tr;
using session::ActionItem, session::shown_keys;
using ui::begin_at_first_item, ui::begin_rows, ui::end_rows, ui::icon_button, ui::key_pressed, ui::open_popups,
    ui::show_keyboard_frame, ui::use_up_arrow;

namespace {

std::vector<std::string> menus_of(std::span<const ActionItem> items) {
  std::vector<std::string> menus;
  for (const ActionItem& item : items)
    if (!item.menu.empty() && (menus.empty() || menus.back() != item.menu)) menus.push_back(item.menu);
  return menus;
}

bool draw_menu_item(const PanelContext& c, const ActionItem& item, const std::string& prefix) {
  const bool chosen =
      ImGui::MenuItem(item.label.c_str(), shown_keys(item.shortcut).c_str(), item.checked, item.enabled);
  c.map.add_item(prefix + item.id);
  return chosen;
}

/// -1 or 1: the arrow that leads from an open menu of the bar to its neighbour, 0: none. An arrow that opens or closes
/// a submenu is not for the bar.
int step_to_neighbour(int popups_before) {
  if (popups_before != 1 || open_popups() != 1) return 0;
  const int step =
      static_cast<int>(key_pressed(ImGuiKey_RightArrow)) - static_cast<int>(key_pressed(ImGuiKey_LeftArrow));
  if (step != 0) use_up_arrow();
  return step;
}

struct DrawnMenu {
  std::string chosen;
  int step = 0;
};

DrawnMenu draw_menu(const PanelContext& c, std::span<const ActionItem> items, const std::string& menu, bool opens) {
  DrawnMenu drawn;
  if (opens) {
    ImGui::OpenPopup(tr(menu.c_str()));
    show_keyboard_frame();
  }
  const bool open = ImGui::BeginMenu(tr(menu.c_str()));
  c.map.add_item("menu:" + menu);
  if (!open) return drawn;
  if (opens) begin_at_first_item();  // ImGui reuses the window of the neighbour, with the item chosen there
  std::vector<ActionItem> own;
  for (const ActionItem& item : items)
    if (item.menu == menu) own.push_back(item);
  const int popups = open_popups();
  drawn.chosen = draw_menu_items(c, own, "menu.");
  if (!opens) drawn.step = step_to_neighbour(popups);
  ImGui::EndMenu();
  return drawn;
}

std::string draw_menus(const PanelContext& c, std::span<const ActionItem> items, int& opens) {
  const std::vector<std::string> menus = menus_of(items);
  const auto count = static_cast<int>(menus.size());
  std::string chosen;
  int next = kNoMenu;
  for (int i = 0; i < count; ++i) {
    DrawnMenu drawn = draw_menu(c, items, menus[static_cast<size_t>(i)], i == opens);
    if (!drawn.chosen.empty()) chosen = std::move(drawn.chosen);
    if (drawn.step != 0) next = (i + drawn.step + count) % count;
  }
  opens = next;
  return chosen;
}

struct Button {
  const char *action, *icon;
};
constexpr Button kToolbar[] = {
    {"new", icon::kNew}, {"open", icon::kOpen}, {"save", icon::kSave}, {"undo", icon::kUndo}, {"redo", icon::kRedo}};

std::string draw_toolbar(const PanelContext& c, std::span<const ActionItem> items) {
  std::string chosen;
  for (const Button& tool : kToolbar)
    for (const ActionItem& item : items) {
      if (item.id != tool.action) continue;
      const std::string tip = item.shortcut.empty() ? item.label : item.label + "   " + shown_keys(item.shortcut);
      if (icon_button(c, tool.action, tool.icon, item.label.c_str(), tip.c_str(), item.enabled)) chosen = item.id;
    }
  return chosen;
}

void draw_title(const PanelContext& c, const std::string& title, float left) {
  const float width = ImGui::GetWindowWidth();
  const ImVec2 size = ImGui::CalcTextSize(title.c_str());
  const float x = std::max(left + c.style.px(24), (width - size.x) / 2);
  if (x + size.x > width) return;  // the title of the window shows it as well
  const ImVec2 at = ImGui::GetWindowPos();
  ImGui::GetWindowDrawList()->AddText(
      {at.x + static_cast<float>(static_cast<int>(x)),
       at.y + static_cast<float>(static_cast<int>((ImGui::GetFrameHeight() - size.y) / 2))},
      c.style.color.muted, title.c_str());
}

}  // namespace

std::string draw_menu_items(const PanelContext& c, std::span<const ActionItem> items, const std::string& prefix) {
  std::string chosen;
  begin_rows(c);
  for (size_t i = 0; i < items.size();) {
    const std::string& submenu = items[i].submenu;
    if (items[i].group && i > 0) ImGui::Separator();
    const bool open = submenu.empty() || ImGui::BeginMenu(tr(submenu.c_str()));
    if (!submenu.empty()) c.map.add_item(prefix + submenu);
    size_t end = i + 1;
    while (!submenu.empty() && end < items.size() && items[end].submenu == submenu) ++end;
    for (; i < end; ++i)
      if (open && draw_menu_item(c, items[i], prefix)) chosen = items[i].id;
    if (open && !submenu.empty()) ImGui::EndMenu();
  }
  end_rows();
  return chosen;
}

std::string draw_menu_bar(const PanelContext& c, std::span<const ActionItem> items, const std::string& title,
                          int& opens) {
  std::string chosen;
  const float pad = c.style.finger > 0 ? ImGui::GetStyle().FramePadding.y : c.style.px(9);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {c.style.px(8), pad});
  if (ImGui::BeginMainMenuBar()) {
    begin_rows(c);
    chosen = draw_menus(c, items, opens);
    end_rows();
    ImGui::Dummy({c.style.px(12), 0});
    if (std::string id = draw_toolbar(c, items); !id.empty()) chosen = id;
    draw_title(c, title, ImGui::GetCursorPosX());
    ImGui::EndMainMenuBar();
  }
  ImGui::PopStyleVar();
  return chosen;
}

}  // namespace weftlight::views
