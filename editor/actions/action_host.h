#pragma once
// The interface that actions work on: the active document and its view, and services of the window, the file dialogs
// and the clipboard. The editor implements it; tests have one without a window.

#include <string>

#include "actions/names.h"
#include "session/document/document.h"
#include "session/editing/document_view.h"
#include "session/files/user_files.h"
#include "session/jobs/draper.h"
#include "session/report.h"

namespace weftlight::actions {

class ActionHost {
 public:
  virtual ~ActionHost() = default;

  virtual const Document& document() const = 0;
  /// The view of the document; settings() are shared by all documents.
  virtual DocumentView& view() = 0;
  virtual const DocumentView& view() const = 0;
  virtual void commit(const Edit& edit) = 0;
  /// Commits it when it is computed, if the draft is still the same.
  virtual void compute(const SlowEdit& edit) = 0;
  virtual void undo() = 0;
  virtual void redo() = 0;
  /// Goes to a step of the history.
  virtual void go_to_step(size_t step) = 0;

  virtual void new_draft() = 0;
  /// The same, with a weave of weave_kinds() chosen.
  virtual void new_draft_of(int weave) = 0;
  virtual void open() = 0;
  virtual void open_path(const std::string& path) = 0;
  /// As a new, unnamed draft: a shipped one is never overwritten.
  virtual void open_copy(const std::string& path) = 0;
  /// Shows recent drafts, or the library, with thumbnails.
  virtual void show_gallery(bool library) = 0;
  virtual void save() = 0;
  virtual void save_as() = 0;
  virtual void save_all() = 0;
  virtual void save_for_others() = 0;
  virtual void export_textures() = 0;
  /// Offers unsaved work of crashed sessions.
  virtual void offer_recovery() = 0;
  virtual bool has_left_work() const = 0;
  /// Shows the next tab (1) or the previous (-1).
  virtual void show_tab(int by) = 0;
  virtual void close_tab() = 0;
  virtual size_t tabs() const = 0;
  /// Index of the active tab.
  virtual size_t tab_place() const = 0;
  virtual void close_other_tabs() = 0;
  virtual void close_tabs_to_right() = 0;
  /// Opens a copy of the draft, unnamed, in a new tab.
  virtual void duplicate() = 0;
  /// Reads the file again from disk.
  virtual void reload() = 0;
  virtual void show_in_folder() = 0;
  virtual bool any_unsaved() const = 0;
  virtual void quit() = 0;

  virtual void ask_print() = 0;
  /// Shows or hides the loom view.
  virtual void toggle_loom() = 0;
  virtual void step_at_loom(bool forwards) = 0;
  virtual void connect_loom() = 0;
  virtual void disconnect_loom() = 0;
  /// Asks for a draft to compare with.
  virtual void ask_other() = 0;
  /// Asks for an environment picture.
  virtual void ask_environment() = 0;
  /// The last report on the draft; null if there is none.
  virtual const Report* last_report() const = 0;
  virtual void ask_size() = 0;
  virtual void ask_notes() = 0;
  virtual void ask_thread() = 0;
  /// Fills the selected threads, or all, with a weave.
  virtual void ask_weave() = 0;
  /// Threading and treadling from named sections.
  virtual void ask_sections() = 0;
  /// Offers the closest weave to an edit that the loom cannot weave.
  virtual void ask_closest_weave() = 0;
  /// Gives the keyboard to a control, by its name in the --ui-map.
  virtual void focus(std::string control) = 0;
  /// The cell under the pointer.
  virtual Hover hover() const = 0;
  virtual Settings& settings() = 0;
  virtual const Settings& settings() const = 0;
  virtual void show_commands() = 0;
  virtual void show_remarks() = 0;
  virtual void toggle_keys() = 0;
  virtual void toggle_theme() = 0;
  virtual void keep_view() = 0;
  virtual void reset_view() = 0;
  /// Goes to a view of the cloth by name (render_data/views.h).
  virtual void go_to_view(const std::string& name) = 0;
  virtual void keep_view_as() = 0;
  virtual void change_views() = 0;
  /// Switches between drape and flat swatch.
  virtual void toggle_flat() = 0;
  /// State of the simulated drape.
  virtual DrapeState drape_state() const = 0;
  virtual void stop_draping() = 0;
  /// Restarts the simulation after a stop or an error.
  virtual void drape_again() = 0;
  /// Shows a message in the status line for a while.
  virtual void say(std::string text) = 0;

  virtual std::string clipboard() const = 0;
  virtual void set_clipboard(const std::string& text) = 0;
};

}  // namespace weftlight::actions
