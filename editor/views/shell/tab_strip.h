#pragma once
// The open drafts as a row of tabs, shown if there are at least two.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "session/action_item.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::ActionItem;
using ui::Style;

struct Tab {
  uint64_t id = 0;
  std::string name, tip;
  bool unsaved = false;
};

struct TabRequest {
  enum class Kind { kNone, kShow, kClose, kMove, kMenu };  // kMenu: show the tab, then its menu
  Kind kind = Kind::kNone;
  uint64_t id = 0;
  size_t place = 0;  // new index, for kMove
};

/// Scroll state of the row.
struct TabStrip {
  float scroll = 0;    // pixels
  uint64_t shown = 0;  // id of the tab that was scrolled to last
  size_t count = 0;
  bool menu_due = false;  // open the menu of the shown tab
};

/// Height of the row; 0 for a single draft.
float tab_strip_height(const Style& style, size_t tabs);
/// Fills the current window. A click shows a tab, a drag moves it, its cross or a middle click closes it; the plus
/// button makes a new draft.
TabRequest draw_tab_strip(PanelContext& c, std::span<const Tab> tabs, uint64_t shown, TabStrip& strip);
/// The context menu of a tab, for the draft that is shown. Returns the id of the chosen action or "".
std::string draw_tab_menu(const PanelContext& c, std::span<const ActionItem> items, TabStrip& strip);

/// Left edges of the tabs, and the right edge of the last, from 0, for the preferred widths. If they do not fit `room`,
/// wide tabs become narrower, but not below `min_width`.
std::vector<float> tab_edges(std::span<const float> preferred, float room, float min_width);

}  // namespace weftlight::views
