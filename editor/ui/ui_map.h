#pragma once
// Positions of controls and grids in window pixels, collected while a frame is drawn, so that tests and assistive
// programs can find them (`--ui-map`).

#include <string>
#include <vector>

namespace weftlight::ui {

struct UiControl {
  std::string name;
  float x = 0, y = 0, w = 0, h = 0;
  // For the keyboard; not part of the --ui-map.
  unsigned item = 0;     // ImGui's id; 0: takes no keyboard
  int depth = 0;         // popups that it lies in
  bool tab_stop = true;  // Tab comes here
  bool field = false;    // takes text
  bool row = false;      // of a list
  bool operator==(const UiControl&) const = default;
};

/// The centre of cell (a, b), both counted from 1, is origin + (a - 1) step_a + (b - 1) step_b.
struct UiGrid {
  std::string name;
  float origin[2] = {0, 0}, step_a[2] = {0, 0}, step_b[2] = {0, 0};
  int count_a = 0, count_b = 0;
  bool operator==(const UiGrid&) const = default;
};

struct UiMap {
  std::vector<UiControl> controls;
  std::vector<UiGrid> grids;
  unsigned focus_next = 0;  // the item that gets the keyboard when it is drawn

  /// All but `focus_next`.
  void clear();
  void add(std::string name, float x, float y, float w, float h);
  /// The ImGui item drawn last.
  void add_item(std::string name);
  /// The same for a row of a list; Tab comes to one of them, the arrows to all.
  void add_row(std::string name, bool tab_stop);
  /// The ImGui item drawn last is a group around this field.
  void add_field(std::string name, unsigned item);
  bool operator==(const UiMap&) const = default;
};

}  // namespace weftlight::ui
