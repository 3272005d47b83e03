#include "app/fixed_window.h"

#include <algorithm>

namespace weftlight::app {

bool begin_fixed(const char* name, const PaneRect& pane, ImVec2 padding, ImGuiWindowFlags flags) {
  ImGui::SetNextWindowPos(pane.at);
  ImGui::SetNextWindowSize({std::max(1.0f, pane.size.x), std::max(1.0f, pane.size.y)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  const bool open = ImGui::Begin(name, nullptr, flags);
  ImGui::PopStyleVar();
  return open;
}

}  // namespace weftlight::app
