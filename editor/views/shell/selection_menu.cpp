#include <imgui.h>

#include "views/shell/action_list.h"

namespace weftlight::views {

std::string draw_selection_menu(const PanelContext& c, std::span<const ActionItem> items) {
  constexpr const char* kName = "###selection_menu";
  if (c.frame.selection_menu) ImGui::OpenPopup(kName);
  if (!ImGui::BeginPopup(kName)) return {};
  std::vector<ActionItem> own;
  for (const ActionItem& item : items)
    if (item.on_selection) own.push_back(item);
  std::string chosen = draw_menu_items(c, own, "context.");
  ImGui::EndPopup();
  return chosen;
}

}  // namespace weftlight::views
