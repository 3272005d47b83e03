#include "ui/ui_map.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <utility>

#include "ui/imgui_compat.h"

namespace weftlight::ui {

void UiMap::clear() {
  controls.clear();
  grids.clear();
}

void UiMap::add(std::string name, float x, float y, float w, float h) {
  controls.push_back({std::move(name), x, y, w, h});
}

void UiMap::add_item(std::string name) {
  const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
  add(std::move(name), a.x, a.y, b.x - a.x, b.y - a.y);
  UiControl& control = controls.back();
  const ImGuiItemFlags flags = last_item_flags();
  control.item = ImGui::GetItemID();
  control.depth = ImGui::GetCurrentContext()->BeginPopupStack.Size;
  control.tab_stop = (flags & (ImGuiItemFlags_NoTabStop | ImGuiItemFlags_Disabled)) == 0;
  control.field = (flags & ImGuiItemFlags_Inputable) != 0;
  if (control.item == 0 || control.item != focus_next) return;
  focus_next = 0;
  give_keyboard_to_item(control.field);
}

void UiMap::add_row(std::string name, bool tab_stop) {
  add_item(std::move(name));
  controls.back().row = true;
  controls.back().tab_stop &= tab_stop;
}

void UiMap::add_field(std::string name, unsigned item) {
  add_item(std::move(name));
  UiControl& control = controls.back();
  control.item = item;
  control.field = true;
  control.tab_stop = (last_item_flags() & ImGuiItemFlags_Disabled) == 0;  // the group itself is none
  if (item == 0 || item != focus_next) return;
  focus_next = 0;
  give_keyboard(item);
}

}  // namespace weftlight::ui
