#pragma once
// The editor: the wiring of its subjects, and the loop. Each subject owns its state and is in a file of its own; here
// they meet in the table of actions, in the frame, and in what follows an edit.

#include <cstdint>
#include <string>
#include <vector>

#include "app/action_table.h"
#include "app/background_tasks.h"
#include "app/cloth_pane.h"
#include "app/dialogs.h"
#include "app/draft_files.h"
#include "app/draft_prompts.h"
#include "app/editing.h"
#include "app/frame_schedule.h"
#include "app/live_export_writer.h"
#include "app/loom_window.h"
#include "app/messages.h"
#include "app/own_yarns.h"
#include "app/panels.h"
#include "app/printing.h"
#include "app/reports.h"
#include "app/start_dialogs.h"
#include "app/tabs.h"
#include "app/texture_exports.h"
#include "app/tool_windows.h"
#include "app/ui_map_file.h"
#include "app/window.h"
#include "commands/exit_codes.h"
#include "platform/desktop.h"
#include "session/editing/intent.h"
#include "session/editing/strokes.h"
#include "session/editing/typing.h"
#include "session/files/user_files.h"
#include "session/session.h"

namespace weftlight::app {

using actions::Subjects;
using commands::EditorOptions;
using session::Intents, session::Session, session::Settings;
using ui::Style, ui::Tip, ui::UiMap;
using views::FrameNotes;

class Editor {
 public:
  Editor(Window& window, const EditorOptions& options);
  /// Handles what has come in since the last turn and draws a frame if one is due; false once the window is to be left.
  bool turn();
  /// After the last turn: keeps the settings.
  void leave();
  /// Without the window system: waits until what is unsaved, and what is being saved, is on the disk, but not for ever.
  /// Returns why not all of it is, and sets `unsaved` if the next start has something to offer.
  std::string keep_work(bool& unsaved);

 private:
  Subjects subjects();
  void frame();
  void begin_frame();
  void apply_input();
  void apply_waiting_input();
  void apply_key(const std::string& key);
  bool walk_through_popup(const std::string& key);
  void draw_window();
  /// Carries out the requests of the panels in their order.
  void carry_out(Intents& wanted);
  /// Takes up what the tasks beside the window did; true if there was anything.
  bool take_results();
  void cancel(const base::ShownTask& task);
  /// Takes what the parts of the window computed in the background; true if there is something to show.
  bool update_background();
  /// Updates picture, live export and derived state after another document was activated.
  void follow_shown();
  /// Called after every change of the shown design.
  void edited();
  void update_title();
  /// The present write error, until it is resolved.
  std::string trouble() const;
  double sleep_s();

  Window& window_;
  Settings settings_;
  Style style_;
  Session session_;
  BackgroundTasks tasks_;  // ends before the session, which its tasks may use
  FrameSchedule schedule_;
  Messages messages_{Window::seconds};
  Editing editing_;
  Dialogs dialogs_;
  LiveExportWriter live_export_;
  Files files_;
  DraftPrompts prompts_;
  OwnYarns own_yarns_;
  StartDialogs start_;
  Tabs tabs_;
  TextureExports exports_;
  Printing printing_;
  ClothPane cloth_;
  LoomWindow loom_;
  Reports reports_;
  Panels panels_;
  ToolWindows tools_;
  ActionTable actions_;

  uint64_t shown_ = 0;  // id of the document last followed
  std::string title_, trouble_;
  bool restyle_ = true;
  int styled_percent_ = 100;  // of the interface, for which style_ is
  // Of the last frame.
  FrameNotes notes_;
  UiMap map_;
  UiMapFile map_file_;
  Tip tip_;
  int opens_menu_ = views::kNoMenu;  // in the next frame, by the keyboard
  bool popup_closed_ = false;
  std::string focus_;  // control that gets the keyboard next
};

}  // namespace weftlight::app
