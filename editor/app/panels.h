#pragma once
// The panes of the window: draft and cloth side by side or the draft alone, the inspector, the status line; or the loom
// in their place.

#include <span>
#include <string>

#include "app/background_tasks.h"
#include "app/cloth_pane.h"
#include "app/editing.h"
#include "app/loom_window.h"
#include "app/messages.h"
#include "app/reports.h"
#include "session/action_item.h"
#include "session/files/user_files.h"
#include "views/common/yarn_strip.h"
#include "views/draft/draft_panel.h"
#include "views/inspector/threads_panel.h"
#include "views/shell/window_layout.h"

namespace weftlight::app {

using session::ActionItem, session::Settings;
using ui::Style;
using views::DraftPictures, views::PanelContext, views::TypedThreads, views::WindowLayout, views::YarnStrip;

class Panels {
 public:
  Panels(Editing& editing, const Settings& settings, ClothPane& cloth, LoomWindow& loom, Reports& reports,
         BackgroundTasks& tasks, Messages& messages);
  struct StatusTexts {
    std::string trouble;  // what could not be written, or empty
    std::string awaits;   // what happens when the saves in progress are done, or empty
  };
  /// Below the tabs. `name`: of the draft, as its tab has it.
  void draw(PanelContext& c, float tabs_height, const std::string& name, std::span<const ActionItem> items,
            const StatusTexts& status);
  /// When something goes by itself; negative if nothing does.
  double changes_at_s() const { return draft_pictures_.minimap.goes_at_s(); }
  /// Another document is shown.
  void forget() { typed_threads_ = {}; }

 private:
  void draw_draft_pane(PanelContext& c, const WindowLayout& layout, const std::string& name,
                       std::span<const ActionItem> items);
  void draw_splitter(PanelContext& c, const WindowLayout& layout) const;
  void draw_inspector(PanelContext& c, const WindowLayout& layout);
  void draw_status(PanelContext& c, const WindowLayout& layout, const StatusTexts& status);
  /// Fraction of the width for the pane of the draft.
  float split_of(const Style& style, ImVec2 size);

  Editing& editing_;
  const Settings& settings_;
  ClothPane& cloth_;
  LoomWindow& loom_;
  Reports& reports_;
  BackgroundTasks& tasks_;
  Messages& messages_;
  DraftPictures draft_pictures_;
  YarnStrip strip_;
  TypedThreads typed_threads_;
  bool cloth_shown_;  // in the last frame
  bool stacked_ = false;
  float fitted_split_ = 0.5f;  // used until the user moves the splitter
};

}  // namespace weftlight::app
