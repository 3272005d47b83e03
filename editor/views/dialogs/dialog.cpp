#include "views/dialogs/dialog.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "design/edits.h"
#include "session/editing/thread_choice.h"
#include "ui/imgui_compat.h"
#include "ui/keyboard.h"
#include "ui/widgets.h"

namespace weftlight::views {

using base::arg, base::fill, base::mark, base::tr, base::tr_n;
using design::SizeLoss, design::lost_by_size;
using draft::Draft, draft::ShedControl, draft::kMaxShafts, draft::kMaxThreads;
using session::named_thread;
using ui::Colors, ui::begin_list, ui::begin_padded_child, ui::blend, ui::close_popups_above, ui::dim_behind_dialogs,
    ui::fitted, ui::key_pressed, ui::muted_text, ui::open_popups, ui::push_font, ui::row_label, ui::segmented,
    ui::text_button;

namespace {

bool escape_pressed() { return key_pressed(ImGuiKey_Escape, false); }

/// Popups up to the dialog that is being drawn.
int dialog_depth() { return ImGui::GetCurrentContext()->BeginPopupStack.Size; }

DialogResult draw_prompt(PanelContext&, std::monostate&) { return {}; }

DialogResult draw_prompt(PanelContext& c, Question& q) {
  heading(c, q.title);
  ImGui::PushTextWrapPos(c.style.px(440));
  ImGui::TextUnformatted(q.text.c_str());
  c.map.add_item("question:" + q.text);
  ImGui::PopTextWrapPos();
  return dialog_result(draw_buttons(c, q.buttons, true, true, q.by_enter), -2);
}

DialogResult draw_prompt(PanelContext& c, PathPrompt& p) {
  heading(c, p.title);
  ImGui::SetNextItemWidth(c.style.px(520));
  begin_here();
  const bool enter = ImGui::InputText("##path", &p.path, ImGuiInputTextFlags_EnterReturnsTrue);
  c.map.add_item("dialog.path");
  const int button = draw_buttons(c, {p.button, mark("Cancel")}, false);
  return dialog_result(enter ? 0 : button);
}

DialogResult draw_prompt(PanelContext& c, NamePrompt& p) {
  heading(c, p.title);
  if (!p.tip.empty()) muted_text(c, p.tip);
  ImGui::SetNextItemWidth(c.style.px(360));
  begin_here();
  const bool enter =
      ImGui::InputText("##name", &p.name, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  c.map.add_item("dialog.name");
  const int button = draw_buttons(c, {p.button, mark("Cancel")}, false);
  return dialog_result(enter ? 0 : button);
}

DialogResult draw_prompt(PanelContext& c, NamesPrompt& p) {
  constexpr int kMaxRows = 10;
  heading(c, p.title);
  const float row = ImGui::GetFrameHeightWithSpacing(), width = c.style.px(380);
  const auto rows = static_cast<float>(std::min(static_cast<int>(p.names.size()), kMaxRows));
  begin_list("##names", {width, rows * row});
  for (size_t i = 0; i < p.names.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    ImGui::PushID(static_cast<int>(i));
    const bool deleted = p.names[i].empty();
    if (i == 0) begin_here();
    ImGui::SetNextItemWidth(width - c.style.px(110));
    ImGui::InputTextWithHint("##name", fill(tr("Will be deleted: {name}"), arg("name", p.before[i])).c_str(),
                             &p.names[i]);
    c.map.add_item("names:" + number);
    ImGui::SameLine();
    if (text_button(c, ("names.drop:" + number).c_str(), deleted ? tr("Restore") : tr("Delete"), nullptr))
      p.names[i] = deleted ? p.before[i] : std::string();
    ImGui::PopID();
  }
  ImGui::EndChild();
  return dialog_result(draw_buttons(c, {mark("Done"), mark("Cancel")}, false));
}

/// What the threads lose with the shafts and treadles that go, a line each.
std::string lost_text(const SizePrompt& p) {
  const Draft& d = p.base->draft;
  if (p.shafts >= d.shafts && p.treadles >= d.treadles) return {};
  const SizeLoss lost = lost_by_size(d, p.ends, p.picks, p.shafts, p.treadles);
  std::string text;
  const auto add = [&](const char* one, int64_t count) {
    if (count > 0) text += (text.empty() ? "" : "\n") + fill(one, arg("count", count));
  };
  add(tr_n("{count} end loses its shaft.", "{count} ends lose their shafts.", lost.ends), lost.ends);
  if (d.shed_control == ShedControl::kLiftplan)
    add(tr_n("{count} pick loses a shaft that it lifts.", "{count} picks lose shafts that they lift.", lost.picks),
        lost.picks);
  else add(tr_n("{count} pick loses its treadle.", "{count} picks lose their treadles.", lost.picks), lost.picks);
  add(tr_n("{count} mark of the tie-up is lost.", "{count} marks of the tie-up are lost.", lost.tieup), lost.tieup);
  return text;
}

DialogResult draw_prompt(PanelContext& c, SizePrompt& p) {
  heading(c, p.title);
  begin_here();
  number(c, "size.ends", tr("Ends"), p.ends, 1, kMaxThreads);
  number(c, "size.picks", tr("Picks"), p.picks, 1, kMaxThreads);
  number(c, "size.shafts", tr("Shafts"), p.shafts, 1, kMaxShafts);
  number(c, "size.treadles", tr("Treadles"), p.treadles, 1, kMaxShafts);
  ImGui::Dummy({0, c.style.px(4)});
  muted_text(c, tr("Loom limits for all other edits; 0: no limit"));
  number(c, "size.loom_shafts", tr("Max. shafts"), p.loom_shafts, 0, kMaxShafts);
  number(c, "size.loom_treadles", tr("Max. treadles"), p.loom_treadles, 0, kMaxShafts);
  if (const std::string lost = lost_text(p); !lost.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.warn);
    ImGui::TextUnformatted(lost.c_str());
    ImGui::PopStyleColor();
    c.map.add_item("size.lost");
  }
  return dialog_result(draw_buttons(c, {p.button, mark("Cancel")}, true));
}

DialogResult draw_prompt(PanelContext& c, NotesPrompt& p) {
  heading(c, tr("Title and notes"));
  bool enter = false;
  const auto field = [&](const char* id, const char* label, std::string& text) {
    row_label(c, label, nullptr);
    ImGui::SetNextItemWidth(c.style.px(420));
    ImGui::PushID(id);
    enter |= ImGui::InputText("##text", &text, ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::PopID();
    c.map.add_item(id);
  };
  begin_here();
  field("notes.title", tr("Title"), p.title);
  field("notes.author", tr("Author"), p.author);
  row_label(c, tr("Notes"), nullptr);
  ImGui::InputTextMultiline("##notes", &p.notes, {c.style.px(420), c.style.px(220)});
  c.map.add_item("notes.text");
  const int button = draw_buttons(c, {mark("Apply"), mark("Cancel")}, false);
  return dialog_result(enter ? 0 : button);
}

constexpr float kGoToWidth = 244;

DialogResult draw_prompt(PanelContext& c, ThreadPrompt& p) {
  heading(c, tr("Go to thread"));
  constexpr const char* kSystems[] = {mark("End"), mark("Pick")};
  int system = p.system == System::kWarp ? 0 : 1;
  if (segmented(c, "goto.system", kSystems, system, c.style.px(kGoToWidth))) {
    p.system = system == 0 ? System::kWarp : System::kWeft;
    // The letter of the other system is no longer right.
    if (const auto named = named_thread(p.typed); named && named->system) p.typed = std::to_string(named->number);
  }
  row_label(c, tr("Number"), tr("As 120; or e120 for an end, p40 for a pick"));
  ImGui::SetNextItemWidth(c.style.px(140));
  // A number that there is not is typed anew.
  bool& anew = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("anew"));
  if (std::exchange(anew, false)) ImGui::SetKeyboardFocusHere();
  begin_here();
  anew = ImGui::InputText("##n", &p.typed, ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_EnterReturnsTrue);
  c.map.add_item("goto.number");
  const auto named = named_thread(p.typed);
  if (named && named->system) p.system = *named->system;
  const bool warp = p.system == System::kWarp;
  const int last = warp ? p.ends : p.picks;
  p.number = named ? named->number : 0;
  const bool there = p.number >= 1 && p.number <= last;
  ImGui::PushStyleColor(ImGuiCol_Text, there || p.typed.empty() ? c.style.color.muted : c.style.color.warn);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + c.style.px(kGoToWidth));
  ImGui::TextUnformatted(!named && !p.typed.empty()
                             ? tr("Type a number, as 120; or e120 for an end, p40 for a pick.")
                             : fill(warp ? tr_n("The draft has {count} end.", "The draft has {count} ends.", last)
                                         : tr_n("The draft has {count} pick.", "The draft has {count} picks.", last),
                                    arg("count", last))
                                   .c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  if (!there) c.map.add_item("goto.none");
  return dialog_result(draw_buttons(c, {mark("Go"), mark("Cancel")}, true, there));
}

constexpr float kRecoveryWidth = 480;
constexpr int kDeleteReports = 100;  // no button of the lower row

void draw_left_work(PanelContext& c, RecoveryPrompt& p) {
  constexpr int kMaxRows = 8;
  heading(c, tr("Recover unsaved work?"));
  muted_text(c, tr_n("Weftlight closed before this draft was saved.",
                     "Weftlight closed before these drafts were saved. The newest is first.",
                     static_cast<int>(p.rows.size())));
  const float width = c.style.px(kRecoveryWidth), when = c.style.px(230);
  const float line = 2 * ImGui::GetTextLineHeightWithSpacing() + c.style.px(4);
  const int shown = std::min(static_cast<int>(p.rows.size()), kMaxRows);
  begin_list("##left", {width, static_cast<float>(shown) * (line + ImGui::GetStyle().ItemSpacing.y)});
  for (int i = 0; i < static_cast<int>(p.rows.size()); ++i) {
    const RecoveryPrompt::Row& row = p.rows[static_cast<size_t>(i)];
    ImGui::PushID(i);
    const ImVec2 at = ImGui::GetCursorPos();
    const std::string id = "recovery:" + std::to_string(i + 1);
    if (list_row(c, id.c_str(), "##row", i == p.chosen, line)) p.chosen = i;
    const ImVec2 next = ImGui::GetCursorPos();
    ImGui::SetCursorPos({at.x + c.style.px(6), at.y + c.style.px(2)});
    ImGui::TextUnformatted(fitted(row.name, when - c.style.px(16)).c_str());
    ImGui::SameLine(when);
    muted_text(c, row.when);
    ImGui::SetCursorPosX(at.x + c.style.px(6));
    muted_text(c, fitted(row.where, width - c.style.px(20)));
    ImGui::SetCursorPos(next);
    ImGui::PopID();
  }
  ImGui::EndChild();
}

/// True if they are to be deleted.
bool draw_reports(PanelContext& c, RecoveryPrompt& p) {
  if (!p.rows.empty()) ImGui::Dummy({0, c.style.px(8)});
  heading(c, tr("Weftlight crashed"));
  const float width = c.style.px(kRecoveryWidth);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
  muted_text(c, tr("This report says where the program stopped and which commands came last. It contains nothing from "
                   "your drafts and is not sent anywhere. Copy it to report the crash to the developers."));
  ImGui::PopTextWrapPos();
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
  begin_padded_child("reports", {width, c.style.px(150)});
  push_font(c.style.font.mono);
  ImGui::TextUnformatted(p.reports.c_str());
  ImGui::PopFont();
  ImGui::EndChild();
  ImGui::PopStyleColor();
  c.map.add_item("recovery.report");
  if (text_button(c, "dialog:Copy report", tr("Copy report"), nullptr)) {
    ImGui::SetClipboardText(p.reports.c_str());
    p.copied = true;
  }
  ImGui::SameLine();
  const bool remove = text_button(c, "dialog:Delete report", tr("Delete report"), nullptr);
  ImGui::SameLine();
  if (p.copied) muted_text(c, tr("Copied"));
  else ImGui::NewLine();
  return remove;
}

DialogResult draw_prompt(PanelContext& c, RecoveryPrompt& p) {
  if (!p.rows.empty()) draw_left_work(c, p);
  if (!p.reports.empty() && draw_reports(c, p)) return dialog_result(kDeleteReports);
  if (p.rows.empty()) return dialog_result(draw_buttons(c, {mark("Later")}, true), 0);
  std::vector<std::string> buttons{mark("Recover"), mark("Later"), mark("Discard")};
  if (p.rows.size() > 1) buttons.insert(buttons.begin() + 1, mark("Recover all"));
  const int pressed = draw_buttons(c, buttons, true);
  return pressed >= 0 && p.button(pressed) == RecoveryPrompt::Button::kLater ? dialog_result(1)
                                                                             : dialog_result(pressed, -2);
}

/// True if the draft follows the choices in the dialog, so that it is to be seen beside it, in its own colours.
bool shows_in_draft(const Dialog& dialog) {
  return std::holds_alternative<WeaveOverPrompt>(dialog) || std::holds_alternative<SectionsPrompt>(dialog) ||
         std::holds_alternative<JoinPrompt>(dialog) || std::holds_alternative<ClosestWeavePrompt>(dialog) ||
         std::holds_alternative<GradientPrompt>(dialog);
}

/// The edit that undoes the preview of a cancelled dialog.
MaybeEdit restored(const Dialog& dialog) {
  if (const auto* over = std::get_if<WeaveOverPrompt>(&dialog)) return restored(*over);
  if (const auto* sections = std::get_if<SectionsPrompt>(&dialog)) return restored(*sections);
  if (const auto* join = std::get_if<JoinPrompt>(&dialog)) return restored(*join);
  if (const auto* closest = std::get_if<ClosestWeavePrompt>(&dialog)) return restored(*closest);
  if (const auto* gradient = std::get_if<GradientPrompt>(&dialog)) return restored(*gradient);
  return {};
}

}  // namespace

bool update_dialog(Dialog& dialog, bool& busy) {
  if (const auto* gallery = std::get_if<GalleryPrompt>(&dialog)) {
    busy = gallery->pictures->busy() || gallery->browser->busy();
    return gallery->pictures->poll() | gallery->browser->poll();
  }
  if (const auto* picture = std::get_if<PicturePrompt>(&dialog)) {
    busy = picture->stage->weaver.busy();
    return picture->stage->poll();
  }
  if (const auto* versions = std::get_if<VersionsPrompt>(&dialog)) {
    busy = versions->pictures->busy();
    return versions->pictures->poll();
  }
  if (const auto* exported = std::get_if<ExportPrompt>(&dialog)) {
    busy = exported->stage->preview.busy() || exported->places->busy();
    return exported->stage->poll() | exported->places->poll();
  }
  const auto* print = std::get_if<PrintPrompt>(&dialog);
  busy = print != nullptr && print->preview->busy();
  return print != nullptr && print->preview->poll();
}

RecoveryPrompt::Button RecoveryPrompt::button(int pressed) const {
  constexpr Button kButtons[] = {Button::kOne, Button::kAll, Button::kLater, Button::kDiscard};
  if (pressed == kDeleteReports) return Button::kDeleteReports;
  if (rows.empty()) return Button::kLater;
  const int skipped = rows.size() > 1 || pressed == 0 ? 0 : 1;
  return kButtons[std::clamp(pressed + skipped, 0, 3)];
}

DialogResult draw_dialog(PanelContext& c, Dialog& dialog) {
  if (std::holds_alternative<std::monostate>(dialog)) return {};
  constexpr const char* kName = "###dialog";
  if (!ImGui::IsPopupOpen(kName)) ImGui::OpenPopup(kName);
  const ImGuiViewport* view = ImGui::GetMainViewport();
  const bool live = shows_in_draft(dialog);
  dim_behind_dialogs(live ? ui::kDimBesideDraft : ui::kDim);
  const bool tall = std::holds_alternative<GalleryPrompt>(dialog) || std::holds_alternative<PrintPrompt>(dialog) ||
                    std::holds_alternative<VersionsPrompt>(dialog) || std::holds_alternative<PicturePrompt>(dialog) ||
                    std::holds_alternative<YarnsPrompt>(dialog);
  const float down =
      tall ? 0.5f : 0.4f;  // of the room that is left, so that a dialog as high as the window is all seen
  ImGui::SetNextWindowPos({view->WorkPos.x + view->WorkSize.x * (live ? 1.0f : 0.5f) - (live ? c.style.px(16) : 0.0f),
                           view->WorkPos.y + view->WorkSize.y * down},
                          ImGuiCond_Always, {live ? 1.0f : 0.5f, down});
  ImGui::SetNextWindowSizeConstraints({1, 1}, {std::max(1.0f, view->WorkSize.x), std::max(1.0f, view->WorkSize.y)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {c.style.px(20), c.style.px(16)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, c.style.px(10));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, live ? 1.0f : 0.0f);
  // The background of a dialog is lighter than that of a panel, and so are its fields.
  const Colors& color = c.style.color;
  ImGui::PushStyleColor(ImGuiCol_FrameBg, blend(color.raised, color.text, 0.08f));
  ImGui::PushStyleColor(ImGuiCol_FrameBgHovered, blend(color.raised, color.text, 0.12f));
  ImGui::PushStyleColor(ImGuiCol_Button, blend(color.raised, color.text, 0.08f));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, blend(color.raised, color.text, 0.14f));
  DialogResult result;
  if (ImGui::BeginPopupModal(kName, nullptr,
                             ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                 ImGuiWindowFlags_HorizontalScrollbar)) {
    const int depth = dialog_depth();
    const bool list_open = open_popups() > depth;
    result = std::visit([&](auto& d) { return draw_prompt(c, d); }, dialog);
    if (list_open && escape_pressed()) close_popups_above(depth);
    else if (result.outcome == DialogOutcome::kOpen && escape_pressed() && !c.frame.popup_closed)
      result = {DialogOutcome::kCancelled, -1, {}};
    if (result.outcome == DialogOutcome::kCancelled)
      if (MaybeEdit back = restored(dialog)) result.edit = std::move(back);
    if (result.outcome != DialogOutcome::kOpen) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  ImGui::PopStyleColor(4);
  ImGui::PopStyleVar(3);
  return result;
}

}  // namespace weftlight::views
