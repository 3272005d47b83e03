#include "ui/keyboard.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <vector>

#include "ui/imgui_compat.h"

namespace weftlight::ui {

namespace {

const UiControl* focused_control(const UiMap& map) {
  const auto at = std::find_if(map.controls.begin(), map.controls.end(),
                               [id = keyboard_item()](const UiControl& one) { return id != 0 && one.item == id; });
  return at == map.controls.end() ? nullptr : &*at;
}

/// The items of the open dialog, in the order in which they are drawn.
std::vector<unsigned> tab_stops(const UiMap& map) {
  std::vector<unsigned> all;
  for (const UiControl& one : map.controls)
    if (one.item != 0 && one.tab_stop && one.depth == open_popups() &&
        std::find(all.begin(), all.end(), one.item) == all.end())
      all.push_back(one.item);
  return all;
}

}  // namespace

void begin_keyboard() { use_keyboard(open_popups() > 0); }

int open_popups() { return ImGui::GetCurrentContext()->OpenPopupStack.Size; }

void close_popups_above(int left) {
  if (open_popups() > left) ImGui::ClosePopupToLevel(left, true);
}

void step_focus(UiMap& map, int by) {
  if (!kOwnTabKey) return;
  const std::vector<unsigned> stops = tab_stops(map);
  if (stops.empty()) return;
  const auto count = static_cast<int>(stops.size());
  const auto now = static_cast<int>(std::find(stops.begin(), stops.end(), keyboard_item()) - stops.begin());
  const int next = now == count ? (by > 0 ? 0 : count - 1) : (now + by + count) % count;
  map.focus_next = stops[static_cast<size_t>(next)];
}

bool takes_enter(const UiMap& map) {
  if (!keyboard_frame_shown()) return false;
  const UiControl* control = focused_control(map);
  return control == nullptr || !control->row;
}

void press_focused(const UiMap& map) {
  const UiControl* control = focused_control(map);
  if (kOwnEnterKey && keyboard_frame_shown() && (control == nullptr || !(control->row || control->field)))
    press_keyboard_item();
}

}  // namespace weftlight::ui
