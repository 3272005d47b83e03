#pragma once
// The editor: the open documents, the panels around the one that is shown, and what the actions do. Everything the
// weaver can do is in the table of actions.h; panels return edits, which are committed here and nowhere else.

#include <functional>
#include <string>
#include <vector>

#include "actions/action_host.h"
#include "actions/actions.h"
#include "app/file_dialog.h"
#include "app/names.h"
#include "app/preview_pane.h"
#include "app/ui_map_file.h"
#include "app/window.h"
#include "commands/commands.h"
#include "session/background_writer.h"
#include "session/document.h"
#include "session/exporter.h"
#include "session/intent.h"
#include "session/loom_link.h"
#include "session/own_output.h"
#include "session/report.h"
#include "session/session.h"
#include "session/strokes.h"
#include "session/typing.h"
#include "session/user_files.h"
#include "views/analysis/analysis_panel.h"
#include "views/dialogs/dialogs.h"
#include "views/draft/draft_panel.h"
#include "views/inspector/yarn_strip.h"
#include "views/shell/action_list.h"
#include "views/shell/history_window.h"
#include "views/shell/tab_strip.h"
#include "views/shell/window_layout.h"

namespace weftlight::app {

class Editor : public ActionHost {
 public:
  Editor(Window& window, const EditorOptions& options);
  void run();

  // What the actions do (actions/action_host.h).
  const Document& document() const override { return session_.active().document; }
  DocumentView& view() override { return session_.active().view; }
  const DocumentView& view() const override { return session_.active().view; }
  void commit(const Edit& edit) override;
  void undo() override;
  void redo() override;
  void go_to_step(size_t step) override;
  void new_draft() override;
  void new_draft_of(int weave) override;
  void open() override;
  void open_path(const std::string& path) override;
  void open_copy(const std::string& path) override;
  void show_gallery(bool library) override;
  void save() override;
  void save_as() override;
  void save_all() override;
  void save_for_others() override;
  void export_textures() override;
  void offer_recovery() override;
  bool has_left_work() const override { return !session_.left().empty(); }
  void show_tab(int by) override;
  void close_tab() override { close(session_.active().id); }
  size_t tabs() const override { return session_.all().size(); }
  size_t tab_place() const override { return session_.active_place(); }
  void close_other_tabs() override;
  void close_tabs_to_right() override;
  void duplicate() override;
  void reload() override;
  void show_in_folder() override;
  bool any_unsaved() const override { return !session_.unsaved().empty(); }
  void quit() override;
  void ask_print() override;
  void toggle_loom() override;
  void step_at_loom(bool forwards) override;
  void connect_loom() override;
  void disconnect_loom() override;
  void ask_other() override;
  void ask_environment() override;
  const Report* last_report() const override;
  void ask_size() override;
  void ask_notes() override;
  void ask_thread() override;
  void ask_weave() override;
  void ask_sections() override;
  void ask_closest_weave() override;
  void focus(std::string control) override { focus_ = std::move(control); }
  Hover hover() const override { return notes_.hover; }
  Settings& settings() override { return settings_; }
  const Settings& settings() const override { return settings_; }
  void show_commands() override;
  void show_remarks() override { remarks_open_ = true; }
  void toggle_keys() override { keys_.open = !keys_.open; }
  void toggle_theme() override;
  void keep_view() override;
  void reset_view() override;
  void go_to_view(const std::string& name) override;
  void keep_view_as() override;
  void change_views() override;
  void toggle_flat() override;
  DrapeState drape_state() const override { return draper_.state(); }
  void stop_draping() override { draper_.stop(); }
  void drape_again() override { draper_.again(document().snapshot()); }
  void say(std::string text) override;
  std::string clipboard() const override;
  void set_clipboard(const std::string& text) override;

 private:
  void frame();
  void draw_window();
  void draw_panels(PanelContext& c, float tabs_height, const std::vector<ActionItem>& items);
  std::vector<Tab> tabs_of() const;
  /// What the weaver does with them, to be done once the frame is through.
  TabRequest draw_tabs(PanelContext& c, float height);
  void carry_out(const TabRequest& requested);
  /// What the panels of a frame asked for, in their order.
  void carry_out(Intents& wanted);
  void change_settings(const SettingsChange& change);
  /// Share of the room that the draft's pane takes.
  float split_of(float room, float height);
  void draw_splitter(PanelContext& c, const WindowLayout& layout);
  void draw_question(PanelContext& c);
  void draw_status(PanelContext& c, const WindowLayout& layout);
  void draw_inspector(PanelContext& c, const WindowLayout& layout);
  /// What was refused in a gesture that is over, and what comes nearest to it.
  void find_closest_weave();
  /// What the panels are to know of the draft; started anew only while somebody looks.
  const Report* report();
  void apply_input();
  void apply_waiting_input();
  void apply_key(const std::string& key);
  bool update_export();
  void run_action(const std::string& id);
  double sleep_s();

  /// What the window begins with.
  static Document first_document();
  /// Another document is shown: the picture, the live export and what is derived follow it.
  void follow_shown();
  /// The design with what the cloth hangs over: its drape, or the flat swatch.
  std::shared_ptr<const Design> hung() const;
  /// Beside the others; nothing of them is lost.
  void open_beside(Document document, Origin origin);
  void edited();
  /// True when there is something to show of the cloth's own drape.
  bool update_drape();
  void report(std::vector<Diagnostic> remarks, const std::string& path);
  void ask(Dialog dialog, std::function<void(int button)> then);
  /// Once the weaver decided about what is unsaved in it.
  void close(uint64_t id);
  /// The same, one after the other; nothing more is closed where the weaver would rather not.
  void close_each(std::vector<uint64_t> ids);
  void close(uint64_t id, const std::function<void()>& then);
  void save_shown(std::function<void()> then);
  /// One after the other, asking where for those without a file; then `then`, but not where one was not saved.
  void save_each(std::vector<uint64_t> ids, const std::function<void()>& then);
  void save_to(const std::string& path, const std::function<void()>& then);
  void ask_path(FileAsk what, const std::string& title, const std::string& start,
                std::function<void(const std::string&)> chosen, const std::string& ending = ".wif");
  void with_ending(const std::string& typed, const std::string& ending,
                   const std::function<void(const std::string&)>& then);
  void start_print(const std::string& path, const PrintPrompt& prompt);
  void export_again();
  void update_title();
  /// The table of actions anew: it names files, keys and views.
  void remake_actions();

  // editor_loom.cpp
  /// What the loom said; true when there is something to show.
  bool update_loom();
  void carry_out(const LoomStep& step);
  bool carry_out(const TypedKey& typed);
  void draw_loom_window(PanelContext& c, const WindowLayout& layout);

  // editor_files.cpp
  /// To the document's own file; asks when another program changed it.
  void save_own(std::function<void()> then);
  /// Where the window has come back to: asks when another program changed the file meanwhile.
  void look_at_file();
  void ask_about_change(bool saving, std::function<void()> then);
  /// The file of the document that is shown, as it is now.
  void read_again();
  void bring_back(size_t left);
  void bring_back_all();
  void keep_live_export();
  /// What could not be written, until it is.
  std::string trouble() const;

  Window& window_;
  EditorOptions options_;
  Settings settings_;
  Style style_;
  Session session_;
  uint64_t shown_ = 0;               // the document that all follows
  FrameNotes notes_;                 // of the last frame
  std::string focus_;                // control that the keyboard goes to next
  std::vector<Diagnostic> remarks_;  // of the document, or on a file that could not be opened
  std::vector<Action> actions_;
  std::vector<std::string> views_in_menu_;
  BackgroundWriter writer_;    // of the live export
  BackgroundWriter exporter_;  // apart, since it takes long
  Exporter sets_{Window::wake};
  std::shared_ptr<ExportPlan> export_plan_ = std::make_shared<ExportPlan>();
  uint64_t exported_ = 0;  // the document that the sets are of
  std::shared_ptr<LiveExport> live_export_;
  std::string live_problem_, trouble_;
  FileDialog file_dialog_;
  Draper draper_{Window::wake};
  PreviewPane preview_;
  DraftPictures draft_pictures_;
  YarnStrip strip_;
  std::string typed_threads_;
  AnalysisState analysis_;
  UiMap map_;
  UiMapFile map_file_;
  ImVec2 pane_{0, 0};
  float fitted_split_ = 0.5f;  // while the weaver has not moved the splitter
  CommandPalette commands_;
  TabStrip tabs_;
  HistoryWindow history_;
  KeysWindow keys_;
  Dialog dialog_;
  bool dialog_busy_ = false;
  std::function<void(int)> answer_;
  std::string message_, title_;
  bool remarks_open_ = false, leaving_ = false, restyle_ = true;
  Strokes strokes_;
  Reporter reporter_;
  LoomLink loom_{Window::wake};
  uint64_t loom_of_ = 0;  // the document that it weaves
  std::string loom_address_, loom_why_;
  LoomLink::State loom_state_ = LoomLink::State::kOff;  // as last shown
  uint64_t weaves_asked_ = 0, sittings_ = 0;
  int frames_due_ = 5;
  Tip tip_;
  double moved_at_s_ = 0, tip_at_s_ = -1, said_at_s_ = 0;
};

}  // namespace weftlight::app
