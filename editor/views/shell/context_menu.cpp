#include <imgui.h>

#include "views/shell/action_list.h"

namespace weftlight::views {

using session::ActionItem;

std::string draw_context_menu(const PanelContext& c, std::span<const ActionItem> items, bool ActionItem::*belongs,
                              const char* name, bool due) {
  const std::string popup = std::string("###") + name;
  if (due) ImGui::OpenPopup(popup.c_str());
  if (!ImGui::BeginPopup(popup.c_str())) return {};
  std::vector<ActionItem> own;
  for (const ActionItem& item : items)
    if (item.*belongs) own.push_back(item);
  std::string chosen = draw_menu_items(c, own, std::string(name) + ".");
  ImGui::EndPopup();
  return chosen;
}

}  // namespace weftlight::views
