#include "views/shell/status_bar.h"

#include <algorithm>

#include "base/text.h"
#include "session/editing/paint.h"
#include "session/editing/selection_state.h"
#include "session/editing/shapes.h"
#include "session/editing/typing.h"
#include "ui/icons.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {

using base::arg, base::fill, base::tr, base::tr_n;
using draft::ShedControl;
using session::SelectDrag, session::Tool, session::describe, session::selection_text, session::shape_text,
    session::typing_text;
using ui::content_right, ui::fitted, ui::muted_text, ui::push_font, ui::text_button, ui::tooltip, ui::with_alpha;
using wif::Severity;

namespace {

ImU32 severity_color(const PanelContext& c, Severity s) {
  return s == Severity::kError     ? c.style.color.error
         : s == Severity::kWarning ? c.style.color.warn
                                   : c.style.color.muted;
}

bool draw_remark_button(const PanelContext& c, std::span<const Diagnostic> remarks) {
  const bool bad =
      std::any_of(remarks.begin(), remarks.end(), [](const Diagnostic& d) { return d.severity != Severity::kNote; });
  const auto count = static_cast<int>(remarks.size());
  const std::string label = (c.style.font.icons ? std::string(bad ? icon::kWarning : icon::kInfo) + " " : "") +
                            fill(tr_n("{count} message", "{count} messages", count), arg("count", count));
  ImGui::PushStyleColor(ImGuiCol_Text, bad ? c.style.color.warn : c.style.color.muted);
  ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0, 0, 0, 0));
  const float pad = c.style.finger > 0 ? ImGui::GetStyle().FramePadding.y : c.style.px(1);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {c.style.px(6), pad});
  const bool pressed =
      text_button(c, "remarks", label.c_str(), tr("Problems found in the opened file, and how they were handled"));
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
  return pressed;
}

void draw_remark(const PanelContext& c, const Diagnostic& d) {
  push_font(c.style.font.mono_small);
  ImGui::PushStyleColor(ImGuiCol_Text, severity_color(c, d.severity));
  ImGui::TextUnformatted(d.line > 0 ? fill(tr("line {number}"), arg("number", d.line)).c_str() : tr("file"));
  ImGui::PopStyleColor();
  ImGui::PopFont();
  ImGui::SameLine(c.style.px(96));
  ImGui::BeginGroup();
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(d.text.c_str());
  if (!d.remedy.empty()) muted_text(c, d.remedy);
  ImGui::PopTextWrapPos();
  ImGui::EndGroup();
  ImGui::Dummy({0, c.style.px(2)});
}

/// By priority: the shape being drawn, the active block or drag; with the select tool the selection; then the cell
/// under the pointer.
std::string status_text(const PanelContext& c, const SelectState& s, const DrawingState& drawing) {
  std::string selected = selection_text(s);
  const std::string hover = describe(c.design, c.cells, c.frame.hover.grid, c.frame.hover.cell);
  if (drawing.shape) return shape_text(*drawing.shape);
  if (s.tool == Tool::kType) return typing_text(drawing.cursor, c.design, c.cells);
  if (s.held || s.drag != SelectDrag::kNone) return selected;
  if (s.tool == Tool::kSelect && !selected.empty()) return selected;
  if (!hover.empty() && *c.frame.hint != '\0') return hover + "    " + c.frame.hint;
  return !hover.empty() ? hover : !selected.empty() ? selected : c.frame.hint;
}

/// A refusal is set off by its colour, on a ground of its own.
void draw_message(const PanelContext& c, const StatusMessage& message, float room) {
  const ImU32 color = message.refusal ? c.style.color.warn : c.style.color.accent;
  const char* sign = message.refusal ? icon::kWarning : icon::kInfo;
  const std::string text = fitted((c.style.font.icons ? std::string(sign) + "  " : "") + message.text, room);
  const ImVec2 at = ImGui::GetCursorScreenPos(), size = ImGui::CalcTextSize(text.c_str());
  const float pad = c.style.px(7), high = c.style.px(3);
  ImGui::GetWindowDrawList()->AddRectFilled({at.x - pad, at.y - high}, {at.x + size.x + pad, at.y + size.y + high},
                                            with_alpha(color, 0.13f), c.style.px(5));
  ImGui::PushStyleColor(ImGuiCol_Text, message.refusal ? color : c.style.color.text);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  c.map.add_item(message.refusal ? "message.refusal" : "message");
  tooltip(c, message.text.c_str());
}

/// The message first, then what is under the pointer as far as there is room.
void draw_texts(const PanelContext& c, const std::string& now, const StatusMessage& message, float room) {
  if (message.text.empty()) return ImGui::TextUnformatted(fitted(now, room).c_str());
  const float left = ImGui::GetCursorPosX(), gap = c.style.px(20);
  draw_message(c, message, room);
  const float used = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x - left + gap;
  if (now.empty() || room - used < c.style.px(80)) return;
  ImGui::SameLine(left + used);
  muted_text(c, fitted(now, room - used));
}

void draw_trouble(const PanelContext& c, const std::string& trouble, float room) {
  ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.error);
  ImGui::TextUnformatted(fitted((c.style.font.icons ? std::string(icon::kWarning) + " " : "") + trouble, room).c_str());
  ImGui::PopStyleColor();
  c.map.add_item("trouble");
  tooltip(c, trouble.c_str());
}

}  // namespace

std::string summary(const Draft& d) {
  const bool liftplan = d.shed_control == ShedControl::kLiftplan;
  const std::string ends = fill(tr_n("{count} end", "{count} ends", d.ends()), arg("count", d.ends()));
  const std::string picks = fill(tr_n("{count} pick", "{count} picks", d.picks()), arg("count", d.picks()));
  const std::string shafts = fill(tr_n("{count} shaft", "{count} shafts", d.shafts), arg("count", d.shafts));
  const std::string control =
      liftplan ? std::string(tr("liftplan"))
               : fill(tr_n("{count} treadle", "{count} treadles", d.treadles), arg("count", d.treadles));
  return fill(tr("{ends} \xC3\x97 {picks}   {shafts}   {treadles}   {shed}"), arg("ends", ends), arg("picks", picks),
              arg("shafts", shafts), arg("treadles", control),
              arg("shed", d.rising ? tr("rising shed") : tr("sinking shed")));
}

bool draw_status_bar(PanelContext& c, const SelectState& select, const DrawingState& drawing,
                     const std::string& trouble, const StatusMessage& message, std::span<const Diagnostic> remarks) {
  push_font(c.style.font.small);
  const float remark_room = remarks.empty() ? 0 : c.style.px(130), gap = c.style.px(16);
  const float right = content_right() - remark_room, room = std::max(0.0f, right - ImGui::GetCursorPosX());
  const std::string facts = summary(c.design.draft);
  // The size of the draft is shown if there is room left.
  if (trouble.empty()) draw_texts(c, status_text(c, select, drawing), message, room);
  else draw_trouble(c, trouble, room);
  const float facts_x = right - ImGui::CalcTextSize(facts.c_str()).x;
  if (ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + gap <= facts_x) {
    ImGui::SameLine(facts_x);
    muted_text(c, facts);
  }
  bool clicked = false;
  if (!remarks.empty()) {
    ImGui::SameLine(right + c.style.px(14));
    clicked = draw_remark_button(c, remarks);
  }
  ImGui::PopFont();
  return clicked;
}

void draw_remarks(PanelContext& c, std::span<const Diagnostic> remarks, bool& open) {
  if (!open) return;
  const ImGuiViewport* view = ImGui::GetMainViewport();
  ImGui::SetNextWindowSize({c.style.px(560), c.style.px(280)}, ImGuiCond_Appearing);
  ImGui::SetNextWindowPos(
      {view->WorkPos.x + view->WorkSize.x - c.style.px(16), view->WorkPos.y + view->WorkSize.y - c.style.px(44)},
      ImGuiCond_Appearing, {1, 1});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, c.style.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, c.style.color.raised);
  if (ImGui::Begin(tr("File messages"), &open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings))
    for (const Diagnostic& d : remarks) draw_remark(c, d);
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  c.map.add("remarks.panel", at.x, at.y, size.x, size.y);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
}

}  // namespace weftlight::views
