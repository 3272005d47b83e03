#pragma once
// The tabs of the open drafts: shown, moved and closed, with a question about unsaved changes; and the end of the
// window.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "actions/tab_actions.h"
#include "app/dialogs.h"
#include "app/draft_files.h"
#include "app/frame_schedule.h"
#include "session/session.h"
#include "views/shell/tab_strip.h"

namespace weftlight::app {

using actions::TabActions;
using session::ActionItem, session::Session;
using ui::Style;
using views::PanelContext, views::Tab, views::TabRequest, views::TabStrip, views::draw_tab_menu,
    views::tab_strip_height;

class Tabs {
 public:
  Tabs(Session& session, Files& files, Dialogs& dialogs, FrameSchedule& schedule)
      : session_(session), files_(files), dialogs_(dialogs), schedule_(schedule) {}

  /// Shows the next tab (1) or the previous (-1).
  void step(int by);
  /// Closes the document; asks first if it has unsaved changes.
  void close(uint64_t id) { close(id, nullptr); }
  void close_others();
  void close_to_right();
  /// Asks about unsaved changes, then leaves.
  void quit();
  /// The name of the shown draft, as its tab has it.
  std::string shown_name() const;
  /// What happens when the saves in progress are done; empty if nothing.
  std::string awaits() const;
  /// True once the window may end.
  bool leaving() const { return leaving_; }

  /// Height of the row; 0 for a single draft.
  float height(const Style& style) const { return tab_strip_height(style, session_.all().size()); }
  /// Draws the row; the request is carried out at the end of the frame.
  TabRequest draw(PanelContext& c, float height);
  /// Draws the menu of a tab. Returns the id of the chosen action or "".
  std::string draw_menu(PanelContext& c, std::span<const ActionItem> items) { return draw_tab_menu(c, items, strip_); }
  void carry_out(const TabRequest& requested);

  TabActions actions();

 private:
  void close(uint64_t id, const std::function<void()>& then);
  /// Closes several, one after the other; stops when the user cancels.
  void close_each(std::vector<uint64_t> ids);
  std::string closing_question(uint64_t id) const;
  std::vector<Tab> shown_tabs() const;

  Session& session_;
  Files& files_;
  Dialogs& dialogs_;
  FrameSchedule& schedule_;
  TabStrip strip_;
  bool leaving_ = false;
};

}  // namespace weftlight::app
