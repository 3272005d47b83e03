// The editor's frame: input, panels, sleep.

#include <algorithm>
#include <utility>
#include <variant>

#include "app/editor.h"
#include "ui/widgets.h"
#include "views/draft/draft_layout.h"
#include "views/draft/draft_panel.h"
#include "views/inspector/palette_panel.h"
#include "views/inspector/scene_panel.h"
#include "views/inspector/threads_panel.h"
#include "views/inspector/yarn_panel.h"
#include "views/shell/status_bar.h"

namespace weftlight::app {
namespace {

constexpr float kInspector = 316, kStatusBar = 28, kSplitter = 6;  // pixels at 96 dpi
constexpr int kFramesAfterEvent = 4;  // a click goes down and up, and what it opened lays itself out
constexpr double kMessageS = 10;      // then hints take its place again
constexpr double kTipS = 0.5;         // a frame when a tooltip is due
constexpr double kCaretS = 0.4;       // a text field's caret blinks
constexpr double kDialogPollS = 0.05;
constexpr double kTroublePollS = 0.25;  // whether what was refused has succeeded, or the other way round
constexpr double kInputS = 0.1;         // of waiting input is taken before a picture is drawn
constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                    ImGuiWindowFlags_NoNavFocus;

bool begin_fixed(const char* name, ImVec2 at, ImVec2 size, ImVec2 padding, ImGuiWindowFlags more = 0) {
  ImGui::SetNextWindowPos(at);
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  const bool open = ImGui::Begin(name, nullptr, kFixed | more);
  ImGui::PopStyleVar();
  return open;
}

}  // namespace

void Editor::run() {
  while (!leaving_) {
    const bool happened = window_.wait(sleep_s());
    if (happened || window_.has_input()) {
      frames_due_ = kFramesAfterEvent;
      tip_at_s_ = Window::seconds() + kTipS;
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
  settings_.end1_right = work_.end1_right;
  settings_.drawdown_style = static_cast<int>(work_.drawdown_style);
  if (work_.warp_unit.mm == 10) settings_.per_inch = work_.per_inch;
  save_settings(settings_);
  journal_.forget(journalled_);
}

double Editor::sleep_s() {
  if (frames_due_ > 0) return 0;
  const double now = Window::seconds();
  double sleep = -1;
  const auto sooner = [&sleep](double s) { sleep = sleep < 0 ? s : std::min(sleep, s); };
  if (tip_at_s_ >= 0) sooner(std::max(0.0, tip_at_s_ - now));
  if (ImGui::GetIO().WantTextInput) sooner(kCaretS);
  if (file_dialog_.waiting() || exporter_.busy()) sooner(kDialogPollS);
  if (journal_.busy() || writer_.busy()) sooner(kTroublePollS);
  return sleep;
}

void Editor::frame() {
  const double now = Window::seconds();
  const bool cloth_changed = preview_.poll() | take_export_news();
  const bool tip_due = tip_at_s_ >= 0 && now >= tip_at_s_;
  const bool draw_now = frames_due_ > 0 || cloth_changed || tip_due || ImGui::GetIO().WantTextInput;
  if (!draw_now) return;
  frames_due_ = std::max(0, frames_due_ - 1);
  if (tip_due) tip_at_s_ = -1;
  if (restyle_ || now == 0) window_.use_style(style_);
  restyle_ = false;
  take_waiting_input();
  const float ratio = window_.pixel_ratio();
  preview_.ask({with_orbit(document_.now().scene, camera_), document_.now().look, static_cast<int>(pane_.x * ratio),
                static_cast<int>(pane_.y * ratio), work_.show_rungs, work_.compare},
               moving_);
  window_.begin_frame();
  take_input();
  draw_window();
  window_.end_frame(style_.color.window);
  map_file_.frame(map_);
  update_title();
}

/// However long a picture takes, what the hand did meanwhile is edited and journalled first: a frame of input after
/// the other, without drawing any.
void Editor::take_waiting_input() {
  const double until = Window::seconds() + kInputS;
  while (window_.has_input() && Window::seconds() < until && !leaving_) {
    window_.begin_frame();
    take_input();
    draw_window();
    Window::drop_frame();
    window_.wait(0);
  }
}

/// True when there is something to show.
bool Editor::take_export_news() {
  std::string news = exporter_.take_error();
  if (news.empty()) news = exporter_.take_message();
  if (!news.empty()) say(news);
  return !news.empty();
}

void Editor::take_input() {
  const bool before = moving_;
  moving_ = ImGui::IsAnyMouseDown() || ImGui::IsAnyItemActive();
  if (moving_ && !before) ++stroke_;
  const std::vector<std::string> keys = window_.take_keys();
  const bool menu_open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  const bool typing = ImGui::GetIO().WantTextInput || menu_open || !std::holds_alternative<std::monostate>(dialog_);
  for (const std::string& key : keys) {
    const std::string wanted = key == "Ctrl+Y" ? "Ctrl+Shift+Z" : key;
    for (const Action& a : actions_)
      if (!typing && a.item.shortcut == wanted) {
        run_action(a.item.id);
        break;
      }
  }
  for (const std::string& path : window_.take_dropped_files()) {
    open_path(path);
    break;
  }
}

void Editor::draw_window() {
  map_.clear();
  PanelContext c{{style_, map_, work_.focus}, document_.now(), document_.cells(), document_.revision(), work_};
  // Edits replace the design that the panels look at: the snapshot keeps it until they are through.
  const auto design = document_.snapshot();
  ImGui::PushFont(style_.font.text);
  const std::vector<ActionItem> items = show(actions_, *this);
  std::string chosen = draw_menu_bar(c, items, title_);
  draw_panels(c);
  if (std::string id = draw_selection_menu(c, items); !id.empty()) chosen = id;
  if (std::string id = draw_command_palette(c, items, commands_); !id.empty()) chosen = id;
  draw_remarks(c, remarks_, remarks_open_);
  draw_keys_window(c, items, keys_open_);
  draw_question(c);
  ImGui::PopFont();
  if (!chosen.empty()) run_action(chosen);
}

void Editor::draw_panels(PanelContext& c) {
  const ImGuiViewport* view = ImGui::GetMainViewport();
  const float x = view->WorkPos.x, y = view->WorkPos.y, status = style_.px(kStatusBar);
  const float height = view->WorkSize.y - status, inspector = style_.px(kInspector);
  const float room = view->WorkSize.x - inspector;
  const float split = static_cast<float>(static_cast<int>(room * split_of(room, height)));
  work_.hint = "";
  MaybeEdit edit;
  const auto take = [&edit](MaybeEdit made) {
    if (made) edit = std::move(made);
  };

  begin_fixed("Draft", {x, y}, {split, height}, {0, 0}, ImGuiWindowFlags_NoScrollWithMouse);
  draw_draft_header(c);
  take(draw_draft(c, cell_texture_));
  ImGui::End();
  draw_splitter(c, x + split, y, height);

  const float gap = style_.px(kSplitter);
  begin_fixed("Cloth", {x + split + gap, y}, {room - split - gap, height}, {0, 0}, ImGuiWindowFlags_NoScrollWithMouse);
  const ImVec2 pane = pane_;
  take(draw_preview(c, preview_.picture(), camera_, pane_));
  if (pane.x != pane_.x || pane.y != pane_.y) frames_due_ = std::max(frames_due_, 2);
  ImGui::End();

  begin_fixed("Inspector", {x + room, y}, {inspector, height}, {style_.px(16), style_.px(8)});
  // The scrollbar's place is kept free, so that nothing jumps when it comes.
  take(draw_palette(c));
  take(draw_threads(c));
  take(draw_yarns(c, strip_));
  take(draw_scene(c));
  draw_analysis(c, analysis_);
  ImGui::End();

  begin_fixed("Status", {x, y + height}, {view->WorkSize.x, status}, {style_.px(14), style_.px(6)});
  if (draw_status_bar(c, trouble_, Window::seconds() - said_at_s_ < kMessageS ? message_ : std::string(), remarks_))
    remarks_open_ = !remarks_open_;
  ImGui::End();
  if (edit) commit(*edit);
  if (work_.select.drag == SelectDrag::kBand) message_.clear();  // it was about what was selected before
  if (!work_.select.notice.empty()) say(std::exchange(work_.select.notice, {}));
  window_.use_crosshair(work_.select.crosshair);
}

void Editor::draw_draft_header(PanelContext& c) {
  const Design& d = c.design;
  const ImVec2 at = ImGui::GetCursorPos();
  const float width = ImGui::GetWindowWidth(), look = style_.px(214), tool = style_.px(112), gap = style_.px(10);
  const float tools_x = std::max(style_.px(100), width - look - tool - gap - style_.px(14));
  const std::string title = d.title.empty() ? document_.name() : d.title;
  ImGui::SetCursorPos({at.x + style_.px(14), at.y + style_.px(10)});
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(style_.font.bold);
  const std::string shown = fitted(title, tools_x - style_.px(14) - gap);
  ImGui::TextUnformatted(shown.c_str());
  ImGui::PopFont();
  if (shown != title) tooltip(c, title.c_str());
  ImGui::SameLine(tools_x);
  constexpr const char* kTools[] = {"Paint", "Select"};
  int in_hand = static_cast<int>(work_.select.tool);
  if (segmented(c, "tool", kTools, in_hand, tool)) work_.select.tool = static_cast<Tool>(in_hand);
  ImGui::SameLine(0, gap);
  constexpr const char* kLooks[] = {"Threads", "Colour", "Structure"};
  int chosen = static_cast<int>(work_.drawdown_style);
  if (segmented(c, "look", kLooks, chosen, look)) work_.drawdown_style = static_cast<DrawdownStyle>(chosen);
  ImGui::SetCursorPos({at.x, at.y + style_.px(10) + ImGui::GetFrameHeight() + style_.px(8)});
}

float Editor::split_of(float room, float height) {
  constexpr float kLeast = 0.42f, kMost = 0.6f, kHeader = 48;
  if (settings_.split > 0) return settings_.split;
  // Chosen with the first pitch, and kept while threads are added.
  if (work_.pitch <= 0)
    fitted_split_ =
        fitting_width(document_.now().draft, style_, room * kLeast, room * kMost, height - style_.px(kHeader)) / room;
  return fitted_split_;
}

void Editor::draw_splitter(PanelContext& c, float x, float top, float height) {
  begin_fixed("Splitter", {x, top}, {style_.px(kSplitter), height}, {0, 0});
  ImGui::InvisibleButton("split", {style_.px(kSplitter), height});
  c.map.add_item("split");
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemActive()) {
    const float room = ImGui::GetMainViewport()->WorkSize.x - style_.px(kInspector);
    const float moved = ImGui::GetIO().MouseDelta.x / room,
                before = settings_.split > 0 ? settings_.split : fitted_split_;
    if (moved != 0) settings_.split = std::clamp(before + moved, 0.2f, 0.8f);
  }
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) settings_.split = work_.pitch = 0;
  tooltip(c, "Drag to give the draft more or less room; double-click for what it fills");
  const ImU32 color = ImGui::IsItemActive() ? style_.color.accent : style_.color.line;
  const float middle = x + static_cast<float>(static_cast<int>(style_.px(kSplitter) / 2));
  ImGui::GetWindowDrawList()->AddRectFilled({middle, top}, {middle + 1, top + height}, color);
  ImGui::End();
}

void Editor::draw_question(PanelContext& c) {
  const DialogAnswer answer = draw_dialog(c, dialog_);
  if (answer.answer == Answer::kNone) return;
  frames_due_ = kFramesAfterEvent;
  const auto then = std::exchange(answer_, nullptr);
  if (answer.answer == Answer::kDone && then) then(answer.button);
  // The answer may have asked the next question.
  if (!answer_) dialog_ = {};
}

}  // namespace weftlight::app
