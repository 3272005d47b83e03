#include "views/shell/status_bar.h"

#include <algorithm>

#include "session/paint.h"
#include "session/selection_state.h"
#include "session/shapes.h"
#include "session/typing.h"
#include "ui/icons.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {
namespace {

std::string count(int n, const char* one, const char* many) { return std::to_string(n) + " " + (n == 1 ? one : many); }

ImU32 severity_color(const PanelContext& c, Severity s) {
  return s == Severity::kError     ? c.style.color.error
         : s == Severity::kWarning ? c.style.color.warn
                                   : c.style.color.muted;
}

bool draw_remark_button(const PanelContext& c, std::span<const Diagnostic> remarks) {
  const bool bad =
      std::any_of(remarks.begin(), remarks.end(), [](const Diagnostic& d) { return d.severity != Severity::kNote; });
  const std::string label = (c.style.font.icons ? std::string(bad ? icon::kWarning : icon::kInfo) + " " : "") +
                            count(static_cast<int>(remarks.size()), "remark", "remarks");
  ImGui::PushStyleColor(ImGuiCol_Text, bad ? c.style.color.warn : c.style.color.muted);
  ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0, 0, 0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {c.style.px(6), c.style.px(1)});
  const bool pressed =
      text_button(c, "remarks", label.c_str(), "What was odd in the opened file, and what was done about it");
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
  return pressed;
}

void draw_remark(const PanelContext& c, const Diagnostic& d) {
  push_font(c.style.font.mono_small);
  ImGui::PushStyleColor(ImGuiCol_Text, severity_color(c, d.severity));
  ImGui::TextUnformatted(d.line > 0 ? ("line " + std::to_string(d.line)).c_str() : "file");
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

/// A shape, a block in hand and a drag speak first; with the select tool news come before the selection, and that
/// before the cell under the pointer.
std::string status_text(const PanelContext& c, const std::string& message) {
  const SelectState& s = c.view.select;
  const std::string selected = selection_text(s),
                    hover = describe(c.design, c.cells, c.frame.hover.grid, c.frame.hover.cell);
  if (c.view.shape) return shape_text(*c.view.shape);
  if (s.tool == Tool::kType && message.empty()) return typing_text(c.view, c.design, c.cells);
  if (s.held || s.drag != SelectDrag::kNone) return selected;
  if (s.tool == Tool::kSelect && !message.empty()) return message;
  if (s.tool == Tool::kSelect && !selected.empty()) return selected;
  if (!hover.empty() && message.empty() && *c.frame.hint != '\0') return hover + "    " + c.frame.hint;
  return !hover.empty() ? hover : !message.empty() ? message : !selected.empty() ? selected : c.frame.hint;
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
  std::string text = count(d.ends(), "end", "ends") + " \xC3\x97 " + count(d.picks(), "pick", "picks") + "   " +
                     count(d.shafts, "shaft", "shafts") + "   ";
  text += d.drive == ShedControl::kLiftplan ? "liftplan" : count(d.treadles, "treadle", "treadles");
  return text + "   " + (d.rising ? "rising" : "sinking") + " shed";
}

bool draw_status_bar(PanelContext& c, const std::string& trouble, const std::string& message,
                     std::span<const Diagnostic> remarks) {
  push_font(c.style.font.small);
  const float remark_room = remarks.empty() ? 0 : c.style.px(110), gap = c.style.px(16);
  const float right = content_right() - remark_room, room = std::max(0.0f, right - ImGui::GetCursorPosX());
  const std::string facts = summary(c.design.draft);
  // What is said comes first; the figures of the draft take what room is left.
  if (trouble.empty()) ImGui::TextUnformatted(fitted(status_text(c, message), room).c_str());
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
  if (ImGui::Begin("Remarks on the file", &open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings))
    for (const Diagnostic& d : remarks) draw_remark(c, d);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
}

}  // namespace weftlight::views
