#pragma once
// The editor: the open documents, the panels of the active one, and the implementation of the actions. Everything the
// user can do is in the table of actions.h; panels return edits, which are committed only here.

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

  // The interface of the actions (actions/action_host.h).
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
  /// Draws the tabs; the request is carried out at the end of the frame.
  TabRequest draw_tabs(PanelContext& c, float height);
  void carry_out(const TabRequest& requested);
  /// Carries out the requests of the panels in their order.
  void carry_out(Intents& wanted);
  void change_settings(const SettingsChange& change);
  /// Fraction of the width for the pane of the draft.
  float split_of(float room, float height);
  void draw_splitter(PanelContext& c, const WindowLayout& layout);
  void draw_question(PanelContext& c);
  void draw_status(PanelContext& c, const WindowLayout& layout);
  void draw_inspector(PanelContext& c, const WindowLayout& layout);
  /// Computes the closest weave to a rejected gesture once it has ended.
  void find_closest_weave();
  /// Starts a new report for the panels if one is visible and outdated.
  void start_report();
  void apply_input();
  void apply_waiting_input();
  void apply_key(const std::string& key);
  bool update_export();
  void run_action(const std::string& id);
  double sleep_s();

  /// The document that the window starts with.
  static Document first_document();
  /// Updates picture, live export and derived state after another document was activated.
  void follow_shown();
  /// The design with its drape, or with the flat swatch.
  std::shared_ptr<const Design> hung() const;
  /// Opens the document in a tab beside the others.
  void open_beside(Document document, Origin origin);
  void edited();
  /// Handles updates of the simulated drape; true if there are any.
  bool update_drape();
  void report(std::vector<Diagnostic> remarks, const std::string& path);
  void ask(Dialog dialog, std::function<void(int button)> then);
  /// Closes the document; asks first if it has unsaved changes.
  void close(uint64_t id);
  /// Closes several, one after the other; stops when the user cancels.
  void close_each(std::vector<uint64_t> ids);
  void close(uint64_t id, const std::function<void()>& then);
  void save_shown(std::function<void()> then);
  /// Saves several, asking for a path for those without a file. Runs `then` only if all were saved.
  void save_each(std::vector<uint64_t> ids, const std::function<void()>& then);
  void save_to(const std::string& path, const std::function<void()>& then);
  void ask_path(FileAsk what, const std::string& title, const std::string& start,
                std::function<void(const std::string&)> chosen, const std::string& ending = ".wif");
  void with_ending(const std::string& typed, const std::string& ending,
                   const std::function<void(const std::string&)>& then);
  void start_print(const std::string& path, const PrintPrompt& prompt);
  void export_again();
  void update_title();
  /// Makes the table of actions again: it contains files, shortcuts and views.
  void remake_actions();

  // editor_loom.cpp
  /// Handles reports of the loom; true if there is something to show.
  bool update_loom();
  void carry_out(const LoomStep& step);
  bool carry_out(const TypedKey& typed);
  void draw_loom_window(PanelContext& c, const WindowLayout& layout);

  // editor_files.cpp
  /// Saves to the document's own file; asks if another program changed it.
  void save_own(std::function<void()> then);
  /// Checks the file when the window or tab becomes active; asks if another program changed it.
  void look_at_file();
  void ask_about_change(bool saving, std::function<void()> then);
  /// Reads the file of the active document again.
  void read_again();
  void bring_back(size_t left);
  void bring_back_all();
  void keep_live_export();
  /// The present write error, until it is resolved.
  std::string trouble() const;

  Window& window_;
  EditorOptions options_;
  Settings settings_;
  Style style_;
  Session session_;
  uint64_t shown_ = 0;               // id of the document last followed
  FrameNotes notes_;                 // of the last frame
  std::string focus_;                // control that gets the keyboard next
  std::vector<Diagnostic> remarks_;  // about the document, or a file that could not be opened
  std::vector<Action> actions_;
  std::vector<std::string> views_in_menu_;
  BackgroundWriter writer_;    // writes the live export
  BackgroundWriter exporter_;  // separate, since it takes long
  Exporter sets_{Window::wake};
  std::shared_ptr<ExportPlan> export_plan_ = std::make_shared<ExportPlan>();
  uint64_t exported_ = 0;  // id of the document that was exported
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
  float fitted_split_ = 0.5f;  // used until the user moves the splitter
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
  uint64_t loom_of_ = 0;  // id of the document that it weaves
  std::string loom_address_, loom_why_;
  LoomLink::State loom_state_ = LoomLink::State::kOff;  // as last shown
  uint64_t weaves_asked_ = 0, sittings_ = 0;
  int frames_due_ = 5;
  Tip tip_;
  double moved_at_s_ = 0, tip_at_s_ = -1, said_at_s_ = 0;
};

}  // namespace weftlight::app
