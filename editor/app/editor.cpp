#include "app/editor.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <variant>

#include "actions/keys.h"
#include "app/file_filters.h"
#include "app/handbook.h"
#include "base/text.h"
#include "platform/page.h"
#include "session/library/gallery.h"
#include "ui/imgui_compat.h"
#include "ui/keyboard.h"
#include "ui/widgets.h"
#include "views/shell/tour.h"

namespace weftlight::app {

using actions::GalleryPage, actions::key_at_loom, actions::runs_while_typing;
using base::arg, base::fill, base::tr;
using session::ActionItem, session::Document, session::DocumentView, session::Edit, session::Gesture, session::GoToStep,
    session::Intent, session::MaybeEdit, session::RunAction, session::SelectDrag, session::SelectState,
    session::SettingsChange, session::Tool, session::load_settings, session::opens_with_gallery, session::save_settings,
    session::type_after_wait, session::type_key, session::waits_until;
using ui::begin_keyboard, ui::close_popups, ui::close_popups_above, ui::open_popups, ui::push_font;
using views::GalleryPrompt, views::PanelContext, views::TabRequest, views::draw_context_menu, views::draw_menu_bar,
    views::draw_tour, views::leave_tour;

namespace {

constexpr double kCaretS = 0.4;  // blink of a text caret
constexpr double kDialogPollS = 0.05;
constexpr double kTroublePollS = 0.25;           // interval of the check for write errors
constexpr std::chrono::seconds kLastWrites{10};  // to a slow disk, after the window system went away
constexpr double kInputS = 0.1;                  // of waiting input is handled before a frame is drawn

}  // namespace

Editor::Editor(Window& window, const EditorOptions& options)
    : window_(window),
      settings_(load_settings()),
      session_(session::recovery_folder(), Files::first_document()),
      editing_(session_, tasks_, messages_, [this] { edited(); }),
      dialogs_(session_, tasks_, messages_, schedule_),
      live_export_(options.live_export),
      files_(session_, settings_, tasks_, dialogs_, messages_, live_export_, [this] { edited(); }),
      prompts_(editing_, settings_, files_, dialogs_, messages_, [this] { cloth_.show_flat(); }),
      own_yarns_(editing_, tasks_, dialogs_, messages_),
      start_(session_, files_, settings_, tasks_, dialogs_, messages_, [this] { prompts_.ask_new_draft(0); }),
      tabs_(session_, files_, dialogs_, schedule_),
      exports_(session_, dialogs_, messages_),
      printing_(editing_, settings_, tasks_, dialogs_, messages_),
      cloth_(editing_, settings_, tasks_, dialogs_, messages_, schedule_),
      loom_(session_, editing_, settings_),
      reports_(session_, editing_, settings_, files_, dialogs_, messages_),
      panels_(editing_, settings_, cloth_, loom_, reports_, tasks_, messages_),
      actions_(subjects()),
      map_file_(options.ui_map) {
  style_.dark = settings_.dark;
  if (!options.files.empty()) files_.start_with(options.files);
  if (!options.notice.empty()) messages_.refuse(options.notice);
  // No tour if a program drives the window.
  const bool driven = !options.ui_map.empty() || !options.live_export.empty();
  if (!settings_.toured && !driven) settings_.tour = 0;
  follow_shown();
  start_.begin(opens_with_gallery(settings_, !options.files.empty(), driven));
}

Subjects Editor::subjects() {
  return {.draft = editing_.actions(),
          .clipboard = {.text =
                            [] {
                              const char* text = ImGui::GetClipboardText();
                              return std::string(text != nullptr ? text : "");
                            },
                        .set_text = [](const std::string& text) { ImGui::SetClipboardText(text.c_str()); }},
          .settings = settings_,
          .window = {.say = [this](std::string text) { messages_.say(std::move(text)); },
                     .refuse = [this](std::string text) { messages_.refuse(std::move(text)); },
                     .hover = [this] { return notes_.hover; },
                     .focus = [this](std::string control) { focus_ = std::move(control); },
                     .open_menus = [this] { opens_menu_ = 0; },
                     .show_commands = [this] { tools_.show_commands(); },
                     .show_handbook = [this] { show_handbook(messages_); },
                     .show_remarks = [this] { messages_.show_remarks(); },
                     .toggle_keys = [this] { tools_.toggle_keys(); },
                     .toggle_theme =
                         [this] {
                           style_.dark = settings_.dark = !style_.dark;
                           restyle_ = true;
                         }},
          .files = {.new_draft = [this](int weave) { prompts_.ask_new_draft(weave); },
                    .open = [this] { files_.open(); },
                    .open_path = [this](const std::string& path) { files_.open_path(path); },
                    .open_copy = [this](const std::string& path) { files_.open_copy(path); },
                    .show_gallery = [this](GalleryPage page) { start_.show_gallery(page); },
                    .save = [this] { files_.save(); },
                    .save_as = [this] { files_.save_as(); },
                    .save_all = [this] { files_.save_all(); },
                    .save_for_others = [this] { files_.save_for_others(); },
                    .any_unsaved = [this] { return !session_.unsaved().empty(); },
                    .duplicate = [this] { files_.duplicate(); },
                    .reload = [this] { files_.reload(); },
                    .show_in_folder = [this] { files_.show_in_folder(); },
                    .offer_recovery = [this] { start_.offer_recovery(); },
                    .has_left_work = [this] { return start_.has_left_work(); },
                    .quit = [this] { tabs_.quit(); }},
          .exports = {.export_textures = [this] { exports_.ask(); }, .print = [this] { printing_.ask(); }},
          .tabs = tabs_.actions(),
          .dialogs = prompts_.actions(),
          .yarns = own_yarns_.actions(),
          .cloth = cloth_.actions(),
          .loom = loom_.actions(),
          .comparison = reports_.actions()};
}

bool Editor::turn() {
  const bool happened = window_.wait(sleep_s());
  if (happened || window_.has_input()) schedule_.input(Window::seconds());
  dialogs_.poll();
  if (window_.take_focus()) files_.look_at_file();
  if (std::string now = trouble(); now != trouble_) {
    trouble_ = std::move(now);
    schedule_.draw_after_event();
  }
  if (window_.wants_close()) {
    window_.set_wants_close(false);
    tabs_.quit();
  }
  if (window_.can_draw()) frame();
  return !tabs_.leaving();
}

void Editor::leave() {
  window_.size(settings_.width, settings_.height);
  // What is still being written is finished without the window.
  window_.hide();
  save_settings(settings_);
  session_.forget_all();
}

std::string Editor::keep_work(bool& unsaved) {
  unsaved = !session_.unsaved().empty();
  tasks_.writing().wait_for(kLastWrites);
  session_.settle_for(kLastWrites);
  save_settings(settings_);
  return session_.problem();
}

double Editor::sleep_s() {
  const double now = Window::seconds();
  double sleep = schedule_.wait_s(now);
  if (sleep == 0) return sleep;
  const auto sooner = [&sleep](double s) { sleep = sleep < 0 ? s : std::min(sleep, s); };
  if (ImGui::GetIO().WantTextInput) sooner(kCaretS);
  if (const double at = panels_.changes_at_s(); at >= 0) sooner(std::max(0.0, at - now));
  if (const auto until = waits_until(editing_.view())) sooner(std::max(0.0, *until - now));
  if (dialogs_.busy() || tasks_.busy() || exports_.busy()) sooner(kDialogPollS);
  if (session_.busy() || live_export_.busy()) sooner(kTroublePollS);
  return sleep;
}

std::string Editor::trouble() const {
  std::string problem = session_.problem();
  return problem.empty() ? live_export_.problem() : problem;
}

bool Editor::take_results() {
  // Not in the middle of a gesture or a dialog.
  const bool taken = tasks_.take(!ImGui::IsAnyMouseDown() && !dialogs_.any());
  if (taken) editing_.take_computed();
  return dialogs_.run_next() || taken;
}

void Editor::cancel(const base::ShownTask& task) {
  files_.cancel(task.kind);
  editing_.cancel(task.kind);
  messages_.say(fill(tr("Cancelled: {task}"), arg("task", task.name)));
}

bool Editor::update_background() {
  const bool dialog_changed = exports_.update() | dialogs_.update();
  const bool changed = cloth_.update() | dialog_changed | reports_.update() | loom_.update() |
                       editing_.commit(type_after_wait(editing_.view(), editing_.document().now(), Window::seconds()));
  // The content may change the layout, and the --ui-map is written only once that is stable.
  if (dialog_changed || (changed && !cloth_.refining())) schedule_.draw(2);
  return changed;
}

void Editor::frame() {
  if (take_results() | tasks_.update_shown()) schedule_.draw(2);
  follow_shown();
  const double now = Window::seconds();
  const bool changed = update_background();
  if (const double at = panels_.changes_at_s(); at >= 0 && now >= at) schedule_.draw(2);
  if (!schedule_.is_due() && !changed && !schedule_.is_tip_due(now) && !ImGui::GetIO().WantTextInput) return;
  schedule_.drawn(now);
  restyle_ |= platform::is_touched() != (style_.finger > 0);
  if (restyle_ || styled_percent_ != settings_.interface_percent) {
    window_.use_style(style_, settings_.interface_percent);
    styled_percent_ = settings_.interface_percent;
    schedule_.draw(3);
  }
  restyle_ = false;
  apply_waiting_input();
  cloth_.ask_picture(window_.pixel_ratio(), window_.screen());
  begin_frame();
  apply_input();
  draw_window();
  window_.end_frame(style_.color.window);
  if (!files_.starting()) map_file_.frame(map_);
  update_title();
}

/// Handles waiting input first, however long a picture takes, so that edits reach the journal: one frame of input after
/// the other, without drawing.
void Editor::apply_waiting_input() {
  const double until = Window::seconds() + kInputS;
  while (window_.has_input() && Window::seconds() < until && !tabs_.leaving()) {
    begin_frame();
    apply_input();
    draw_window();
    Window::drop_frame();
    window_.wait(0);
  }
}

void Editor::begin_frame() {
  begin_keyboard();
  const int open = open_popups();
  window_.begin_frame();
  popup_closed_ = open_popups() < open;
}

void Editor::apply_input() {
  actions_.follow(editing_.document());
  bool pressed = false;
  for (int button = 0; button < ImGuiMouseButton_COUNT; ++button) pressed |= ImGui::IsMouseClicked(button);
  editing_.strokes().frame(pressed, ImGui::IsAnyMouseDown() || ImGui::IsAnyItemActive());
  const std::vector<std::string> keys = window_.take_keys();
  if (pressed || !keys.empty()) messages_.begin_action();
  for (const std::string& key : keys) apply_key(key == "Alt" ? "F10" : key);
  if (dialogs_.any() && !dialogs_.shows<GalleryPrompt>()) return;
  for (const std::string& path : window_.take_dropped_files()) {
    if (dialogs_.any()) close_popups();
    dialogs_.close();
    files_.open_path(path);
  }
}

/// The keys of dialogs, menus and lists. True if the key is theirs; a command closes menus and runs.
bool Editor::walk_through_popup(const std::string& key) {
  if (key == "Tab" || key == "Shift+Tab") step_focus(map_, key == "Tab" ? 1 : -1);
  if (key == "Enter") press_focused(map_);
  if (dialogs_.any()) return true;  // they close themselves
  const bool of_menus = key == "Alt" || key == "F10", command = runs_while_typing(key) && !of_menus;
  if (of_menus || command) close_popups();
  if (key == "Escape") {
    close_popups_above(open_popups() - 1);
    popup_closed_ = true;
  }
  return !command;
}

/// Handles a key that types no text: closes a popup or runs an action.
void Editor::apply_key(const std::string& key) {
  if (tools_.take_key(key)) return;
  if (key == "Escape" && popup_closed_) return;  // ImGui has closed it
  if (open_popups() > 0 && walk_through_popup(key)) return;
  if (dialogs_.any()) return;
  if (key == "Escape" && tools_.have_keyboard()) return;  // they close themselves
  if (tools_.shows_commands() || (ImGui::GetIO().WantTextInput && !runs_while_typing(key))) return;
  DocumentView& view = editing_.view();
  if (const std::string id = view.at_loom.open ? key_at_loom(key) : ""; !id.empty()) return actions_.run(id);
  if (view.select.tool == Tool::kType &&
      editing_.commit(type_key(view, editing_.document().now(), settings_, key, Window::seconds())))
    return;
  if (key == "Escape" && settings_.tour >= 0) return leave_tour(settings_);
  // Escape closes the messages once it has nothing of the draft to cancel.
  if (key == "Escape" && !actions_.is_enabled("select_none") && messages_.close_remarks()) return;
  // Redo by Ctrl+Y, too, unless it was given to another command.
  if (!actions_.run_key(key) && key == "Ctrl+Y") actions_.run("redo");
}

void Editor::draw_window() {
  follow_shown();
  editing_.find_closest_weave();
  actions_.follow(editing_.document());
  reports_.start();
  map_.clear();
  notes_ = {};
  notes_.now_s = Window::seconds();
  tip_.begin(schedule_.rest_s(notes_.now_s));
  notes_.popup_closed = popup_closed_;
  Intents wanted;
  const Document& document = editing_.document();
  PanelContext c{
      {style_, map_, tip_, focus_}, document.now(), document.cells(), session_.revision(), settings_, notes_, wanted};
  push_font(style_.font.text);
  const std::vector<ActionItem> items = actions_.items();
  wanted.add_action(draw_menu_bar(c, items, session_.all().size() > 1 ? std::string() : title_, opens_menu_));
  const float tabs_height = tabs_.height(style_);
  const TabRequest requested = tabs_.draw(c, tabs_height);
  panels_.draw(c, tabs_height, tabs_.shown_name(), items, {trouble_, tabs_.awaits()});
  wanted.add_action(draw_context_menu(c, items, &ActionItem::on_selection, "context", c.frame.selection_menu));
  wanted.add_action(tabs_.draw_menu(c, items));
  wanted.add_action(tools_.draw_commands(c, items));
  messages_.draw_remarks(c);
  tools_.draw_history_and_keys(c, document, items);
  if (!dialogs_.any() && !editing_.view().at_loom.open) draw_tour(c, items);
  dialogs_.draw(c);
  ImGui::PopFont();
  carry_out(wanted);
  // Last, since it may activate another draft.
  tabs_.carry_out(requested);
  if (const auto task = tasks_.take_cancelled()) cancel(*task);
  SelectState& select = editing_.view().select;
  if (select.drag == SelectDrag::kBand) messages_.clear();  // it was about the earlier selection
  if (!select.notice.empty()) messages_.say(std::exchange(select.notice, {}));
  if (!select.refusal.empty()) messages_.refuse(std::exchange(select.refusal, {}));
  if (window_.take_silent_clipboard())
    messages_.refuse(tr("The program that owns the clipboard is not responding; copy the text again."));
  window_.use_crosshair(notes_.crosshair);
  if (notes_.again) schedule_.draw(1);
  // ImGui lays out a new tooltip in one frame and shows it in the next; the --ui-map is written once it is stable.
  if (tip_.drawn && !tip_.shown) schedule_.draw(3);
}

void Editor::carry_out(Intents& wanted) {
  const uint64_t about = shown_;
  for (const Intent& one : wanted.take()) {
    // An action may activate another draft; later requests for the first one are dropped.
    const bool of_window = std::holds_alternative<RunAction>(one) || std::holds_alternative<SettingsChange>(one);
    if (!of_window && session_.active().id != about) continue;
    if (const auto* edit = std::get_if<Edit>(&one)) editing_.commit(*edit);
    else if (const auto* action = std::get_if<RunAction>(&one)) actions_.run(action->id);
    else if (const auto* change = std::get_if<SettingsChange>(&one)) change->run(settings_);
    else if (const auto* to = std::get_if<GoToStep>(&one)) editing_.go_to_step(to->step);
    else if (const MaybeEdit made = std::get<Gesture>(one).run(editing_.view(), editing_.document().now()))
      editing_.commit(*made);
  }
}

void Editor::follow_shown() {
  if (shown_ == session_.active().id) return;
  shown_ = session_.active().id;
  messages_.follow(session_.active().remarks);
  reports_.forget();
  panels_.forget();
  edited();
}

void Editor::edited() {
  cloth_.follow();
  files_.keep_live_export();
  exports_.follow();
  schedule_.draw(3);
}

void Editor::update_title() {
  const std::string title = (editing_.document().is_saved() ? "" : "\xE2\x97\x8F ") + tabs_.shown_name();
  if (title != title_) window_.set_title(title + " \xE2\x80\x93 Weftlight");
  title_ = title;
}

}  // namespace weftlight::app
