#pragma once
// A desk for tests of the table of actions: one document and its view, and no window.

#include <string>
#include <utility>

#include "actions/actions.h"
#include "session/scene_views.h"

namespace weftlight::actions {

/// A desk without a window: what needs one does nothing.
class BareDesk : public ActionHost {
 public:
  explicit BareDesk(Design design) : document_(std::move(design)) {}
  const Document& document() const override { return document_; }
  DocumentView& view() override { return view_; }
  const DocumentView& view() const override { return view_; }
  void commit(const Edit& edit) override { document_.commit(edit, edit.stroke); }
  void undo() override { document_.undo(); }
  void redo() override { document_.redo(); }
  void go_to_step(size_t step) override { document_.go_to(step); }
  void new_draft() override {}
  void new_draft_of(int) override {}
  void ask_thread() override {}
  void ask_weave() override {}
  void ask_sections() override {}
  void ask_closest_weave() override {}
  Settings& settings() override { return settings_; }
  const Settings& settings() const override { return settings_; }
  void open() override {}
  void open_path(const std::string&) override {}
  void open_copy(const std::string&) override {}
  void show_gallery(bool) override {}
  void save() override {}
  void save_as() override {}
  void save_all() override {}
  void save_for_others() override {}
  void export_textures() override {}
  void offer_recovery() override {}
  bool has_left_work() const override { return false; }
  void show_tab(int) override {}
  void close_tab() override {}
  size_t tabs() const override { return 1; }
  size_t tab_place() const override { return 0; }
  void close_other_tabs() override {}
  void close_tabs_to_right() override {}
  void duplicate() override {}
  void reload() override {}
  void show_in_folder() override {}
  bool any_unsaved() const override { return !document_.is_saved(); }
  void quit() override {}
  void ask_print() override {}
  void toggle_loom() override { view_.at_loom.open = !view_.at_loom.open; }
  void step_at_loom(bool forwards) override {
    if (const MaybeEdit edit = step_by_hand(view_.at_loom, document_.now(), forwards, false).edit) commit(*edit);
  }
  void connect_loom() override {}
  void disconnect_loom() override {}
  void ask_other() override {}
  void ask_environment() override {}
  const Report* last_report() const override { return nullptr; }
  void ask_size() override {}
  void ask_notes() override {}
  void show_commands() override {}
  void show_remarks() override {}
  void toggle_keys() override {}
  void toggle_theme() override {}
  void keep_view() override {}
  void reset_view() override {}
  void go_to_view(const std::string& name) override {
    if (const auto to = view_named(document_.now(), name, 800, 600))
      if (const MaybeEdit edit = session::go_to_view(view_.cloth, document_.now(), *to)) commit(*edit);
  }
  void keep_view_as() override { commit(keep_view_edit(view_.cloth, free_view_name(document_.now()))); }
  void change_views() override { commit(rename_views_edit({"", "Other"})); }
  void toggle_flat() override { view_.cloth.flat = !view_.cloth.flat; }
  void focus(std::string) override {}
  Hover hover() const override { return {}; }
  DrapeState drape_state() const override { return drape_; }
  void stop_draping() override { drape_ = {DrapeStage::kStopped, 0, {}}; }
  void drape_again() override { drape_ = {DrapeStage::kFalling, 0, {}}; }
  void say(std::string) override {}
  std::string clipboard() const override { return clipboard_; }
  void set_clipboard(const std::string& text) override { clipboard_ = text; }

 private:
  Document document_;
  DocumentView view_;
  Settings settings_;
  std::string clipboard_;
  DrapeState drape_{DrapeStage::kFalling, 0.5f, {}};
};

}  // namespace weftlight::actions
