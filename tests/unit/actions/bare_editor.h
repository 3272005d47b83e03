#pragma once
// An editor for tests of the table of actions: one document and its view, and no window.

#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "actions/actions.h"
#include "session/editing/scene_views.h"

namespace weftlight::actions {

using design::Design;
using scene::view_named;
using session::Document, session::DocumentView, session::DrapeStage, session::DrapeState, session::Edit, session::Hover,
    session::MaybeEdit, session::Report, session::Settings, session::SlowEdit, session::free_view_name,
    session::go_to_view, session::keep_view_edit, session::rename_views_edit, session::step_by_hand;

/// What needs a window does nothing.
class BareEditor {
 public:
  explicit BareEditor(Design design) : document_(std::move(design)) {}
  BareEditor(const BareEditor&) = delete;
  BareEditor& operator=(const BareEditor&) = delete;

  /// Begins anew with another design; the subjects stay.
  void begin(Design design) {
    document_ = Document(std::move(design));
    view_ = {};
    settings_ = {};
    clipboard_.clear();
    drape_ = kSimulating;
  }
  const Document& document() const { return document_; }
  DocumentView& view() { return view_; }
  void commit(const Edit& edit) { document_.commit(edit, edit.stroke); }
  void compute(const SlowEdit& edit) {
    std::stop_source stop;
    if (edit.onto) stop.request_stop();  // takes a minute
    const base::TaskProgress progress(stop.get_token());
    commit({edit.label, [&](Design d) { return edit.apply(d, progress).value_or(d); }});
  }
  void undo() { document_.undo(); }
  void redo() { document_.redo(); }
  void go_to_step(size_t step) { document_.go_to(step); }
  /// What the window said last that it could not do.
  const std::string& refused() const { return refused_; }
  void set_clipboard(const std::string& text) { clipboard_ = text; }
  /// The actions refer to this editor.
  const Subjects& subjects() const { return subjects_; }

 private:
  static inline const DrapeState kSimulating{DrapeStage::kSimulating, 0.5f, {}};

  Subjects make_subjects() {
    const auto nothing = [] {};
    return {.draft = {.document = [this]() -> const Document& { return document_; },
                      .view = [this]() -> DocumentView& { return view_; },
                      .commit = [this](const Edit& edit) { commit(edit); },
                      .compute = [this](const SlowEdit& edit) { compute(edit); },
                      .undo = [this] { undo(); },
                      .redo = [this] { redo(); }},
            .clipboard = {.text = [this] { return clipboard_; },
                          .set_text = [this](const std::string& text) { clipboard_ = text; }},
            .settings = settings_,
            .window = {.say = [](const std::string&) {},
                       .refuse = [this](const std::string& text) { refused_ = text; },
                       .hover = [] { return Hover{}; },
                       .focus = [](const std::string&) {},
                       .open_menus = nothing,
                       .show_commands = nothing,
                       .show_handbook = nothing,
                       .show_remarks = nothing,
                       .toggle_keys = nothing,
                       .toggle_theme = nothing},
            .files = {.new_draft = [](int) {},
                      .open = nothing,
                      .open_path = [](const std::string&) {},
                      .open_copy = [](const std::string&) {},
                      .show_gallery = [](GalleryPage) {},
                      .save = nothing,
                      .save_as = nothing,
                      .save_all = nothing,
                      .save_for_others = nothing,
                      .any_unsaved = [this] { return !document_.is_saved(); },
                      .duplicate = nothing,
                      .reload = nothing,
                      .show_in_folder = nothing,
                      .offer_recovery = nothing,
                      .has_left_work = [] { return false; },
                      .quit = nothing},
            .exports = {.export_textures = nothing, .print = nothing},
            .tabs = {.count = [] { return size_t{1}; },
                     .active = [] { return size_t{0}; },
                     .step = [](int) {},
                     .close = nothing,
                     .close_others = nothing,
                     .close_to_right = nothing},
            .dialogs = {.size = nothing,
                        .notes = nothing,
                        .go_to = nothing,
                        .weave = nothing,
                        .sections = nothing,
                        .picture = nothing,
                        .versions = nothing,
                        .gradient = nothing,
                        .delete_color = nothing,
                        .delete_yarn = nothing,
                        .join = nothing,
                        .closest_weave = nothing},
            .yarns = {.show_library = nothing, .keep = nothing},
            .cloth = {.reset_view = nothing,
                      .save_view = nothing,
                      .save_view_as = [this] { commit(keep_view_edit(view_.cloth, free_view_name(document_.now()))); },
                      .change_views =
                          [this] {
                            commit(rename_views_edit({"", "Other"}));
                          },
                      .go_to_view = [this](const std::string& name) { go_to(name); },
                      .toggle_flat = [this] { view_.cloth.flat = !view_.cloth.flat; },
                      .toggle_true_distance = [this] { view_.cloth.true_distance = !view_.cloth.true_distance; },
                      .measure_screen = [] {},
                      .choose_environment = nothing,
                      .drape = [this] { return drape_; },
                      .stop_drape =
                          [this] {
                            drape_ = {DrapeStage::kStopped, 0, {}};
                          },
                      .restart_drape =
                          [this] {
                            drape_ = {DrapeStage::kSimulating, 0, {}};
                          }},
            .loom = {.toggle = [this] { view_.at_loom.open = !view_.at_loom.open; },
                     .step = [this](bool forwards) { step_at_loom(forwards); },
                     .tabby = nothing,
                     .tabby_between = nothing,
                     .say = [] {},
                     .work = [this](session::LoomWork work) { view_.at_loom.work = work; },
                     .connect = nothing,
                     .disconnect = nothing,
                     .open_page = nothing,
                     .close_page = nothing,
                     .renew_code = nothing,
                     .serves_page = [] { return true; }},
            .comparison = {.choose_draft = nothing, .report = [] { return static_cast<const Report*>(nullptr); }}};
  }
  void go_to(const std::string& name) {
    if (const auto to = view_named(document_.now(), name, 800, 600))
      if (const MaybeEdit edit = go_to_view(view_.cloth, document_.now(), *to)) commit(*edit);
  }
  void step_at_loom(bool forwards) {
    if (const MaybeEdit edit = step_by_hand(view_.at_loom, document_.now(), forwards, false).edit) commit(*edit);
  }

  Document document_;
  DocumentView view_;
  Settings settings_;
  std::string clipboard_, refused_;
  DrapeState drape_ = kSimulating;
  Subjects subjects_ = make_subjects();
};

}  // namespace weftlight::actions
