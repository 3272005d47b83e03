#pragma once
// What the actions work on: the open document and its view, and what needs a window, a file dialog or the
// clipboard. The editor is one; a test brings its own, without a window.

#include <string>

#include "actions/names.h"
#include "session/document.h"
#include "session/document_view.h"
#include "session/draper.h"
#include "session/report.h"
#include "session/user_files.h"

namespace weftlight::actions {

class ActionHost {
 public:
  virtual ~ActionHost() = default;

  virtual const Document& document() const = 0;
  /// Of the document; what all documents are seen with is in settings().
  virtual DocumentView& view() = 0;
  virtual const DocumentView& view() const = 0;
  virtual void commit(const Edit& edit) = 0;
  virtual void undo() = 0;
  virtual void redo() = 0;
  /// To a step of the history.
  virtual void go_to_step(size_t step) = 0;

  virtual void new_draft() = 0;
  /// The same, beginning with a weave of weave_kinds().
  virtual void new_draft_of(int weave) = 0;
  virtual void open() = 0;
  virtual void open_path(const std::string& path) = 0;
  /// As a new, unnamed draft: a shipped one is never overwritten.
  virtual void open_copy(const std::string& path) = 0;
  /// The drafts that were open lately, or the library, with pictures.
  virtual void show_gallery(bool library) = 0;
  virtual void save() = 0;
  virtual void save_as() = 0;
  virtual void save_all() = 0;
  virtual void save_for_others() = 0;
  virtual void export_textures() = 0;
  /// Unsaved work that crashed sessions left.
  virtual void offer_recovery() = 0;
  virtual bool has_left_work() const = 0;
  /// The next tab (1) or the one before (-1).
  virtual void show_tab(int by) = 0;
  virtual void close_tab() = 0;
  virtual size_t tabs() const = 0;
  /// Of the shown one among them, from 0.
  virtual size_t tab_place() const = 0;
  virtual void close_other_tabs() = 0;
  virtual void close_tabs_to_right() = 0;
  /// The draft as it is, unnamed, in a tab beside its own.
  virtual void duplicate() = 0;
  /// The file once more, as it is on the disk.
  virtual void reload() = 0;
  virtual void show_in_folder() = 0;
  virtual bool any_unsaved() const = 0;
  virtual void quit() = 0;

  virtual void ask_print() = 0;
  /// The window shows the loom, or no longer.
  virtual void toggle_loom() = 0;
  virtual void step_at_loom(bool forwards) = 0;
  virtual void connect_loom() = 0;
  virtual void disconnect_loom() = 0;
  /// Which draft the open one is held against.
  virtual void ask_other() = 0;
  /// Which picture lights the cloth.
  virtual void ask_environment() = 0;
  /// The last that was worked out of the draft; null: none.
  virtual const Report* last_report() const = 0;
  virtual void ask_size() = 0;
  virtual void ask_notes() = 0;
  virtual void ask_thread() = 0;
  /// A weave over the selected threads, or over all.
  virtual void ask_weave() = 0;
  /// Threading and treadling from named sections.
  virtual void ask_sections() = 0;
  /// What comes nearest to what was painted and could not be woven, to be taken or left.
  virtual void ask_closest_weave() = 0;
  /// The control gets the keyboard, by its name in the --ui-map.
  virtual void focus(std::string control) = 0;
  /// What the pointer is over.
  virtual Hover hover() const = 0;
  virtual Settings& settings() = 0;
  virtual const Settings& settings() const = 0;
  virtual void show_commands() = 0;
  virtual void show_remarks() = 0;
  virtual void toggle_keys() = 0;
  virtual void toggle_theme() = 0;
  virtual void keep_view() = 0;
  virtual void reset_view() = 0;
  /// A view of the cloth by its name (render_data/named_views.h).
  virtual void go_to_view(const std::string& name) = 0;
  virtual void keep_view_as() = 0;
  virtual void change_views() = 0;
  /// A flat swatch in the place of the drape, or the drape again.
  virtual void toggle_flat() = 0;
  /// Of the cloth's own drape.
  virtual DrapeState drape_state() const = 0;
  virtual void stop_draping() = 0;
  /// After it was stopped, or failed.
  virtual void drape_again() = 0;
  /// In the status line, for a while.
  virtual void say(std::string text) = 0;

  virtual std::string clipboard() const = 0;
  virtual void set_clipboard(const std::string& text) = 0;
};

}  // namespace weftlight::actions
