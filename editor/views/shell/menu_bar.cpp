#include <algorithm>
#include <utility>
#include <vector>

#include "base/text.h"
#include "ui/icons.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/shell/action_list.h"

namespace weftlight::views {

using base::tr;
using session::ActionItem;
using ui::icon_button, ui::show_keyboard_frame;

namespace {

std::vector<std::string> menus_of(std::span<const ActionItem> items) {
  std::vector<std::string> menus;
  for (const ActionItem& item : items)
    if (!item.menu.empty() && (menus.empty() || menus.back() != item.menu)) menus.push_back(item.menu);
  return menus;
}

bool draw_menu_item(const PanelContext& c, const ActionItem& item, const std::string& prefix) {
  const bool chosen = ImGui::MenuItem(item.label.c_str(), item.shortcut.c_str(), item.checked, item.enabled);
  c.map.add_item(prefix + item.id);
  return chosen;
}

std::string draw_menu(const PanelContext& c, std::span<const ActionItem> items, const std::string& menu, bool opens) {
  std::string chosen;
  if (opens) {
    ImGui::OpenPopup(tr(menu.c_str()));
    show_keyboard_frame();
  }
  const bool open = ImGui::BeginMenu(tr(menu.c_str()));
  c.map.add_item("menu:" + menu);
  if (!open) return chosen;
  std::vector<ActionItem> own;
  for (const ActionItem& item : items)
    if (item.menu == menu) own.push_back(item);
  chosen = draw_menu_items(c, own, "menu.");
  ImGui::EndMenu();
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
      const std::string tip = item.shortcut.empty() ? item.label : item.label + "   " + item.shortcut;
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
  return chosen;
}

std::string draw_menu_bar(const PanelContext& c, std::span<const ActionItem> items, const std::string& title,
                          bool open_first) {
  std::string chosen;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {c.style.px(8), c.style.px(9)});
  if (ImGui::BeginMainMenuBar()) {
    for (const std::string& menu : menus_of(items))
      if (std::string id = draw_menu(c, items, menu, std::exchange(open_first, false)); !id.empty()) chosen = id;
    ImGui::Dummy({c.style.px(12), 0});
    if (std::string id = draw_toolbar(c, items); !id.empty()) chosen = id;
    draw_title(c, title, ImGui::GetCursorPosX());
    ImGui::EndMainMenuBar();
  }
  ImGui::PopStyleVar();
  return chosen;
}

}  // namespace weftlight::views
