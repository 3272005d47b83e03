#pragma once
// The open drafts as a row of tabs. It is there from the second one on.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "session/action_item.h"
#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

struct Tab {
  uint64_t id = 0;
  std::string name, tip;
  bool unsaved = false;
};

struct TabRequest {
  enum class Kind { kNone, kShow, kClose, kMove, kMenu };  // kMenu: it is shown, then its menu
  Kind kind = Kind::kNone;
  uint64_t id = 0;
  size_t place = 0;  // of kMove
};

/// How the row stands where there are more tabs than room.
struct TabStrip {
  float scroll = 0;    // pixels
  uint64_t shown = 0;  // that was brought into sight
  size_t count = 0;
  bool menu_due = false;  // a right click showed a tab: its menu opens
};

/// Height of the row, none for a single draft.
float tab_strip_height(const Style& style, size_t tabs);
/// Fills the current window. A click shows a tab, a drag moves it, its cross or a middle click closes it; the plus
/// behind the last one asks for a new draft.
TabRequest draw_tab_strip(PanelContext& c, std::span<const Tab> tabs, uint64_t shown, TabStrip& strip);
/// What a right click on a tab offers, of the draft that is then shown; id of the action that was chosen, or empty.
std::string draw_tab_menu(const PanelContext& c, std::span<const ActionItem> items, TabStrip& strip);

/// Left edges of tabs that would like to be so wide, and the right one of the last, from 0: side by side in `room`,
/// narrower where they do not fit, but never below `least`.
std::vector<float> tab_edges(std::span<const float> wanted, float room, float least);

}  // namespace weftlight::views
