#include "ui/ui_map.h"

#include <imgui.h>

#include <utility>

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
}

}  // namespace weftlight::ui
