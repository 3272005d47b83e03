// The editor's frame: input, panels, sleep.

#include <algorithm>
#include <filesystem>
#include <utility>
#include <variant>

#include "actions/keys.h"
#include "app/editor.h"
#include "base/text.h"
#include "session/scene_views.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/analysis/comparison_panel.h"
#include "views/analysis/report_panel.h"
#include "views/analysis/yarn_need_panel.h"
#include "views/draft/closest_weave_notice.h"
#include "views/draft/draft_header.h"
#include "views/draft/draft_layout.h"
#include "views/draft/draft_panel.h"
#include "views/inspector/accuracy_rows.h"
#include "views/inspector/palette_panel.h"
#include "views/inspector/scene_panel.h"
#include "views/inspector/threads_panel.h"
#include "views/inspector/yarn_panel.h"
#include "views/shell/history_window.h"
#include "views/shell/status_bar.h"
#include "views/shell/tour.h"

namespace weftlight::app {

using base::mark;
using base::tr;

namespace {

constexpr int kFramesAfterEvent = 4;  // for press, release, and the layout of what a click opened
constexpr double kMessageS = 10;      // then hints replace it again
constexpr double kTipS = 0.5;         // delay of the frame that shows a tooltip
constexpr double kCaretS = 0.4;       // blink of a text caret
constexpr double kDialogPollS = 0.05;
constexpr double kTroublePollS = 0.25;  // interval of the check for write errors
constexpr double kInputS = 0.1;         // of waiting input is handled before a frame is drawn
constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                    ImGuiWindowFlags_NoNavFocus;

bool begin_fixed(const char* name, const PaneRect& pane, ImVec2 padding, ImGuiWindowFlags flags) {
  ImGui::SetNextWindowPos(pane.at);
  ImGui::SetNextWindowSize({std::max(1.0f, pane.size.x), std::max(1.0f, pane.size.y)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  const bool open = ImGui::Begin(name, nullptr, flags);
  ImGui::PopStyleVar();
  return open;
}

}  // namespace

void Editor::run() {
  while (!leaving_) {
    const bool happened = window_.wait(sleep_s());
    if (happened || window_.has_input()) {
      frames_due_ = kFramesAfterEvent;
      moved_at_s_ = Window::seconds();
      tip_at_s_ = moved_at_s_ + kTipS;
    }
    file_dialog_.poll();
    if (window_.take_focus()) look_at_file();
    if (std::string now = trouble(); now != trouble_) {
      trouble_ = std::move(now);
      frames_due_ = kFramesAfterEvent;
    }
    if (window_.wants_close()) {
      window_.set_wants_close(false);
      quit();
    }
    frame();
  }
  int width = 0, height = 0;
  window_.size(width, height);
  settings_.width = width;
  settings_.height = height;
  save_settings(settings_);
  session_.forget_all();
}

double Editor::sleep_s() {
  if (frames_due_ > 0) return 0;
  const double now = Window::seconds();
  double sleep = -1;
  const auto sooner = [&sleep](double s) { sleep = sleep < 0 ? s : std::min(sleep, s); };
  if (tip_at_s_ >= 0) sooner(std::max(0.0, tip_at_s_ - now));
  if (ImGui::GetIO().WantTextInput) sooner(kCaretS);
  if (const auto until = waits_until(view())) sooner(std::max(0.0, *until - now));
  if (file_dialog_.waiting() || exporter_.busy() || sets_.busy() || reporter_.busy() || dialog_busy_)
    sooner(kDialogPollS);
  if (session_.busy() || writer_.busy()) sooner(kTroublePollS);
  return sleep;
}

void Editor::frame() {
  follow_shown();
  const double now = Window::seconds();
  const bool dialog_changed = update_export() | update_dialog(dialog_, dialog_busy_);
  const bool cloth_changed = preview_.poll() | dialog_changed | reporter_.poll() | update_loom() | update_drape() |
                             carry_out(type_after_wait(view(), document().now(), now));
  // The content may change the layout, and the --ui-map is written only once that is stable.
  if (dialog_changed) frames_due_ = std::max(frames_due_, 2);
  if (cloth_changed && !preview_.picture().refining) frames_due_ = std::max(frames_due_, 2);
  const bool tip_due = tip_at_s_ >= 0 && now >= tip_at_s_;
  const bool draw_now = frames_due_ > 0 || cloth_changed || tip_due || ImGui::GetIO().WantTextInput;
  if (!draw_now) return;
  frames_due_ = std::max(0, frames_due_ - 1);
  if (tip_due) tip_at_s_ = -1;
  if (restyle_ || now == 0) window_.use_style(style_);
  restyle_ = false;
  apply_waiting_input();
  const float ratio = window_.pixel_ratio();
  preview_.ask({seen_scene(view().cloth, document().now()), document().now().look, static_cast<int>(pane_.x * ratio),
                static_cast<int>(pane_.y * ratio), settings_.show_methods, settings_.compare,
                settings_.by_time ? settings_.picture_ms : 0},
               strokes_.going_on());
  window_.begin_frame();
  apply_input();
  draw_window();
  window_.end_frame(style_.color.window);
  map_file_.frame(map_);
  update_title();
}

/// Handles waiting input first, however long a picture takes, so that edits reach the journal: one frame of input after
/// the other, without drawing.
void Editor::apply_waiting_input() {
  const double until = Window::seconds() + kInputS;
  while (window_.has_input() && Window::seconds() < until && !leaving_) {
    window_.begin_frame();
    apply_input();
    draw_window();
    Window::drop_frame();
    window_.wait(0);
  }
}

/// Shows messages of exports and analysis; true if there is something to show.
bool Editor::update_export() {
  std::string message = exporter_.take_error();
  if (message.empty()) message = exporter_.take_message();
  if (message.empty()) message = sets_.take_message();
  if (message.empty()) message = reporter_.take_problem();
  if (!message.empty()) say(message);
  return sets_.take_news() || !message.empty();
}

void Editor::apply_input() {
  bool pressed = false;
  for (int button = 0; button < ImGuiMouseButton_COUNT; ++button) pressed |= ImGui::IsMouseClicked(button);
  strokes_.frame(pressed, ImGui::IsAnyMouseDown() || ImGui::IsAnyItemActive());
  for (const std::string& key : window_.take_keys()) apply_key(key == "Ctrl+Y" ? "Ctrl+Shift+Z" : key);
  if (std::holds_alternative<std::monostate>(dialog_) || std::holds_alternative<GalleryPrompt>(dialog_))
    for (const std::string& path : window_.take_dropped_files()) {
      if (std::exchange(dialog_, {}).index() != 0) close_popups();
      open_path(path);
    }
}

/// Handles a key that types no text: closes a popup or runs an action.
void Editor::apply_key(const std::string& key) {
  if (!keys_.waiting.empty()) {
    keys_.pressed = key;
    return;
  }
  if (!std::holds_alternative<std::monostate>(dialog_)) return;  // dialogs handle their own keys
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) {
    const bool command = runs_while_typing(key);
    if (key == "Escape" || command) close_popups();
    if (!command) return;
  }
  if (commands_.open || (ImGui::GetIO().WantTextInput && !runs_while_typing(key))) return;
  if (const std::string id = view().at_loom.open ? key_at_loom(key) : ""; !id.empty()) return run_action(id);
  if (view().select.tool == Tool::kType &&
      carry_out(type_key(view(), document().now(), settings_, key, Window::seconds())))
    return;
  for (const Action& a : actions_)
    if (a.item.shortcut == key) return run_action(a.item.id);
}

/// True if the key was used.
bool Editor::carry_out(const TypedKey& typed) {
  for (const Edit& edit : typed.edits) commit(edit);
  return typed.taken;
}

void Editor::draw_window() {
  follow_shown();
  find_closest_weave();
  map_.clear();
  tip_.begin(Window::seconds() - moved_at_s_);
  notes_ = {};
  Intents wanted;
  PanelContext c{{style_, map_, tip_, focus_},
                 document().now(),
                 document().cells(),
                 session_.revision(),
                 settings_,
                 notes_,
                 wanted};
  start_report();
  push_font(style_.font.text);
  const std::vector<ActionItem> items = show(actions_, *this);
  wanted.add_action(draw_menu_bar(c, items, session_.all().size() > 1 ? std::string() : title_));
  const float tabs_height = tab_strip_height(style_, session_.all().size());
  const TabRequest requested = draw_tabs(c, tabs_height);
  draw_panels(c, tabs_height, items);
  wanted.add_action(draw_context_menu(c, items, &ActionItem::on_selection, "context", c.frame.selection_menu));
  wanted.add_action(draw_tab_menu(c, items, tabs_));
  wanted.add_action(draw_command_palette(c, items, commands_));
  draw_remarks(c, remarks_, remarks_open_);
  draw_history(c, document(), history_);
  draw_keys_window(c, items, keys_);
  if (std::holds_alternative<std::monostate>(dialog_)) draw_tour(c, items);
  draw_question(c);
  ImGui::PopFont();
  carry_out(wanted);
  // Last, since it may activate another draft.
  carry_out(requested);
  if (view().select.drag == SelectDrag::kBand) message_.clear();  // it was about the earlier selection
  if (!view().select.notice.empty()) say(std::exchange(view().select.notice, {}));
  window_.use_crosshair(notes_.crosshair);
  if (notes_.again) frames_due_ = std::max(frames_due_, 1);
  // ImGui lays out a new tooltip in one frame and shows it in the next; the --ui-map is written once it is stable.
  if (tip_.drawn && !tip_.shown) frames_due_ = std::max(frames_due_, 3);
}

void Editor::carry_out(Intents& wanted) {
  const uint64_t about = shown_;
  for (const Intent& one : wanted.take()) {
    // An action may activate another draft; later requests for the first one are dropped.
    const bool of_window = std::holds_alternative<RunAction>(one) || std::holds_alternative<SettingsChange>(one);
    if (!of_window && session_.active().id != about) continue;
    if (const auto* edit = std::get_if<Edit>(&one)) commit(*edit);
    else if (const auto* action = std::get_if<RunAction>(&one)) run_action(action->id);
    else if (const auto* change = std::get_if<SettingsChange>(&one)) change_settings(*change);
    else if (const auto* to = std::get_if<GoToStep>(&one)) go_to_step(to->step);
    else if (const MaybeEdit made = std::get<Gesture>(one).run(view(), document().now())) commit(*made);
  }
}

void Editor::change_settings(const SettingsChange& change) {
  const auto keys = settings_.keys;
  const auto recent = settings_.recent;
  change.run(settings_);
  if (settings_.keys != keys || settings_.recent != recent) remake_actions();
}

/// "twill.wif", "Overshot"; with the folder if two have the same name.
std::vector<Tab> Editor::tabs_of() const {
  std::vector<Tab> tabs;
  for (const auto& open : session_.all()) {
    const Document& d = open->document;
    tabs.push_back({open->id, d.shown_name(), d.path().empty() ? tr("Not saved yet") : d.path(), !d.is_saved()});
  }
  const std::vector<Tab> plain = tabs;
  for (size_t i = 0; i < tabs.size(); ++i) {
    const std::filesystem::path folder = std::filesystem::path(session_.all()[i]->document.path()).parent_path();
    const auto same = std::count_if(plain.begin(), plain.end(), [&](const Tab& t) { return t.name == plain[i].name; });
    if (same > 1 && !folder.empty()) tabs[i].name += " \xE2\x80\x93 " + folder.filename().string();
  }
  return tabs;
}

TabRequest Editor::draw_tabs(PanelContext& c, float height) {
  if (height <= 0) return {};
  const ImGuiViewport* view = ImGui::GetMainViewport();
  begin_fixed("Tabs", {view->WorkPos, {view->WorkSize.x, height}}, {0, 0}, kFixed | ImGuiWindowFlags_NoScrollWithMouse);
  const TabRequest requested = draw_tab_strip(c, tabs_of(), session_.active().id, tabs_);
  ImGui::End();
  return requested;
}

void Editor::carry_out(const TabRequest& requested) {
  if (requested.kind == TabRequest::Kind::kNone) return;
  frames_due_ = kFramesAfterEvent;
  if (requested.kind == TabRequest::Kind::kMove) return session_.move(requested.id, requested.place);
  if (requested.kind == TabRequest::Kind::kClose) return close(requested.id);
  tabs_.menu_due = requested.kind == TabRequest::Kind::kMenu;
  if (requested.id == session_.active().id) return;
  session_.show(requested.id);
  look_at_file();
}

void Editor::draw_panels(PanelContext& c, float tabs_height, const std::vector<ActionItem>& items) {
  const ImGuiViewport* view = ImGui::GetMainViewport();
  const ImVec2 at{view->WorkPos.x, view->WorkPos.y + tabs_height};
  const ImVec2 size{view->WorkSize.x, std::max(0.0f, view->WorkSize.y - tabs_height)};
  const float room = shared_width(style_, size.x, settings_.inspector);
  const WindowLayout l = lay_out_window(style_, at, size, split_of(room, size.y), settings_.inspector);
  const DocumentView& v = session_.active().view;
  if (v.at_loom.open) {
    draw_loom_window(c, l);
    return draw_status(c, l);
  }
  begin_fixed("Draft", l.draft, {0, 0}, kFixed | ImGuiWindowFlags_NoScrollWithMouse);
  draw_draft_header(c, document().name(), v.select.tool, items);
  draw_draft(c, v, last_report(), draft_pictures_);
  ImGui::End();
  draw_closest_weave_notice(c, v.rejected_edit, l.draft.at,
                            {l.draft.at.x + l.draft.size.x, l.draft.at.y + l.draft.size.y});
  draw_splitter(c, l);

  begin_fixed("Cloth", l.cloth, {0, 0}, kFixed | ImGuiWindowFlags_NoScrollWithMouse);
  const ImVec2 pane = pane_;
  draw_preview(c, v.cloth, preview_.picture(), pane_);
  if (pane.x != pane_.x || pane.y != pane_.y) frames_due_ = std::max(frames_due_, 2);
  ImGui::End();

  if (l.inspector.shown()) draw_inspector(c, l);
  draw_status(c, l);
}

void Editor::draw_status(PanelContext& c, const WindowLayout& l) {
  begin_fixed("Status", l.status, {style_.px(14), style_.px(6)}, kFixed);
  if (draw_status_bar(c, view().select, view().drawing, trouble_,
                      Window::seconds() - said_at_s_ < kMessageS ? message_ : std::string(), remarks_))
    remarks_open_ = !remarks_open_;
  ImGui::End();
}

void Editor::draw_inspector(PanelContext& c, const WindowLayout& l) {
  constexpr const char* kTabs[] = {mark("Threads"), mark("Yarns"), mark("Cloth"), mark("Analysis")};
  begin_fixed("Inspector", l.inspector, {style_.px(16), style_.px(10)}, kFixed);
  int tab = focus_.starts_with("threads.") ? 0 : c.settings.inspector_tab;
  segmented(c, "inspector", kTabs, tab);
  if (tab != c.settings.inspector_tab) c.wanted.change_settings([tab](Settings& s) { s.inspector_tab = tab; });
  ImGui::Dummy({0, style_.px(2)});
  ImGui::BeginChild(kTabs[tab], {0, 0});
  const DocumentView& v = view();
  if (tab == 0) {
    c.wanted.add(draw_palette(c, v.drawing));
    c.wanted.add(draw_threads(c, v.chosen, v.units, typed_threads_));
  } else if (tab == 1) {
    c.wanted.add(draw_yarns(c, v.drawing, strip_));
  } else if (tab == 2) {
    c.wanted.add(draw_scene(c, draper_.state()));
    c.wanted.add(draw_accuracy(c));
  } else {
    draw_comparison(c, v.differences, last_report());
    draw_report(c, v.analysis, last_report());
    draw_analysis(c, analysis_);
    draw_yarn_need(c, v.analysis);
  }
  ImGui::EndChild();
  ImGui::End();
}

void Editor::start_report() {
  const bool looked_at = view().analysis.show_floats || settings_.show_repeat || view().differences.other ||
                         (settings_.inspector && settings_.inspector_tab == 3);
  if (looked_at)
    reporter_.on(document().snapshot(), document().cells(), session_.revision(), view().analysis.float_limit,
                 view().differences.other);
}

const Report* Editor::last_report() const {
  const Report* last = reporter_.last();
  return last != nullptr && session_.is_of_active(last->revision) ? last : nullptr;
}

float Editor::split_of(float room, float height) {
  constexpr float kMin = 0.42f, kMax = 0.6f, kAround = 76;  // header and status line, pixels at 96 dpi
  if (settings_.split > 0) return settings_.split;
  // Computed with the first pitch, and kept while threads are added.
  if (view().draft.pitch <= 0)
    fitted_split_ = fitting_width(document().now().draft, style_, room * kMin, room * kMax,
                                  std::max(1.0f, height - style_.px(kAround))) /
                    room;
  return fitted_split_;
}

void Editor::draw_splitter(PanelContext& c, const WindowLayout& l) {
  const auto [at, size] = l.splitter;
  begin_fixed("Splitter", l.splitter, {0, 0}, kFixed);
  hit_area("split", size);
  c.map.add_item("split");
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemActive()) {
    const float moved = ImGui::GetIO().MouseDelta.x / l.room,
                now = std::clamp((c.settings.split > 0 ? c.settings.split : fitted_split_) + moved, 0.2f, 0.8f);
    if (moved != 0) c.wanted.change_settings([now](Settings& s) { s.split = now; });
  }
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    c.wanted.change_settings([](Settings& s) { s.split = 0; });
    c.wanted.change_view([](DocumentView& v) { v.draft.pitch = 0; });
  }
  tooltip(c, tr("Drag to resize the draft. Double-click to fit it."));
  const ImU32 color = ImGui::IsItemActive() ? style_.color.accent : style_.color.line;
  const float middle = at.x + static_cast<float>(static_cast<int>(size.x / 2));
  ImGui::GetWindowDrawList()->AddRectFilled({middle, at.y}, {middle + 1, at.y + size.y}, color);
  ImGui::End();
}

void Editor::draw_question(PanelContext& c) {
  DialogResult result = draw_dialog(c, dialog_);
  c.wanted.add(std::move(result.edit));
  if (result.outcome == DialogOutcome::kOpen) return;
  if (std::holds_alternative<ClosestWeavePrompt>(dialog_))
    c.wanted.change_view([](DocumentView& v) { v.differences.closest.reset(); });
  frames_due_ = kFramesAfterEvent;
  const auto then = std::exchange(answer_, nullptr);
  if (result.outcome == DialogOutcome::kDone && then) then(result.button);
  // The callback may have opened the next dialog.
  if (!answer_) dialog_ = {};
}

}  // namespace weftlight::app
