#include "panels/dialogs.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "panels/widgets.h"

namespace weftlight {
namespace {

bool enter_pressed() { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false); }
bool escape_pressed() { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false); }

bool primary_button(PanelContext& c, const char* id, const char* label) {
  ImGui::PushStyleColor(ImGuiCol_Button, c.style.color.accent);
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, blend(c.style.color.accent, c.style.color.text, 0.15f));
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, blend(c.style.color.accent, c.style.color.text, 0.3f));
  ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.paper);
  const bool pressed = text_button(c, id, label, nullptr);
  ImGui::PopStyleColor(4);
  return pressed;
}

/// The buttons at the lower right, the first the primary one and outermost. Index pressed or -1.
int draw_buttons(PanelContext& c, const std::vector<std::string>& labels, bool enter_presses_first) {
  const ImGuiStyle& s = ImGui::GetStyle();
  float width = -s.ItemSpacing.x;
  for (const std::string& l : labels) width += ImGui::CalcTextSize(l.c_str()).x + 2 * s.FramePadding.x + s.ItemSpacing.x;
  ImGui::Dummy({0, c.style.px(6)});
  ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), ImGui::GetWindowContentRegionMax().x - width));
  int pressed = -1;
  for (int i = static_cast<int>(labels.size()) - 1; i >= 0; --i) {
    const std::string id = "dialog:" + labels[static_cast<size_t>(i)];
    const char* label = labels[static_cast<size_t>(i)].c_str();
    if (i == 0 ? primary_button(c, id.c_str(), label) : text_button(c, id.c_str(), label, nullptr)) pressed = i;
    if (i > 0) ImGui::SameLine();
  }
  return pressed < 0 && enter_presses_first && enter_pressed() ? 0 : pressed;
}

DialogAnswer answered(int button, int leave_button = 1) {
  if (button < 0) return {};
  return {button == leave_button ? Answer::kLeft : Answer::kDone, button};
}

void heading(PanelContext& c, const std::string& text) {
  ImGui::PushFont(c.style.font.bold);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopFont();
  ImGui::Dummy({0, c.style.px(2)});
}

DialogAnswer draw(PanelContext&, std::monostate&) { return {}; }

DialogAnswer draw(PanelContext& c, Question& q) {
  heading(c, q.title);
  ImGui::PushTextWrapPos(c.style.px(440));
  ImGui::TextUnformatted(q.text.c_str());
  ImGui::PopTextWrapPos();
  return answered(draw_buttons(c, q.buttons, true), -2);
}

DialogAnswer draw(PanelContext& c, PathPrompt& p) {
  heading(c, p.title);
  ImGui::SetNextItemWidth(c.style.px(520));
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool enter = ImGui::InputText("##path", &p.path, ImGuiInputTextFlags_EnterReturnsTrue);
  c.map.add_item("dialog.path");
  const int button = draw_buttons(c, {p.button, "Cancel"}, false);
  return answered(enter ? 0 : button);
}

void number(PanelContext& c, const char* id, const char* label, int& value, int max) {
  row_label(c, label, nullptr);
  ImGui::PushFont(c.style.font.mono);
  ImGui::SetNextItemWidth(c.style.px(140));
  ImGui::PushID(id);
  ImGui::InputInt("##n", &value, 1, 10);
  ImGui::PopID();
  ImGui::PopFont();
  c.map.add_item(id);
  value = std::clamp(value, 1, max);
}

DialogAnswer draw(PanelContext& c, SizePrompt& p) {
  heading(c, p.title);
  number(c, "size.ends", "Ends", p.ends, kMaxThreads);
  number(c, "size.picks", "Picks", p.picks, kMaxThreads);
  number(c, "size.shafts", "Shafts", p.shafts, kMaxShafts);
  number(c, "size.treadles", "Treadles", p.treadles, kMaxShafts);
  return answered(draw_buttons(c, {p.button, "Cancel"}, true));
}

DialogAnswer draw(PanelContext& c, NotesPrompt& p) {
  heading(c, "Title and notes");
  const auto field = [&](const char* id, const char* label, std::string& text) {
    row_label(c, label, nullptr);
    ImGui::SetNextItemWidth(c.style.px(420));
    ImGui::PushID(id);
    ImGui::InputText("##text", &text);
    ImGui::PopID();
    c.map.add_item(id);
  };
  field("notes.title", "Title", p.title);
  field("notes.author", "Author", p.author);
  row_label(c, "Notes", nullptr);
  ImGui::InputTextMultiline("##notes", &p.notes, {c.style.px(420), c.style.px(220)});
  c.map.add_item("notes.text");
  return answered(draw_buttons(c, {"Keep", "Cancel"}, false));
}

}  // namespace

DialogAnswer draw_dialog(PanelContext& c, Dialog& dialog) {
  if (std::holds_alternative<std::monostate>(dialog)) return {};
  constexpr const char* kName = "###dialog";
  if (!ImGui::IsPopupOpen(kName)) ImGui::OpenPopup(kName);
  const ImGuiViewport* view = ImGui::GetMainViewport();
  ImGui::SetNextWindowPos({view->WorkPos.x + view->WorkSize.x / 2, view->WorkPos.y + view->WorkSize.y * 0.4f}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {c.style.px(20), c.style.px(16)});
  DialogAnswer answer;
  if (ImGui::BeginPopupModal(kName, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove)) {
    answer = std::visit([&](auto& d) { return draw(c, d); }, dialog);
    if (answer.answer == Answer::kNone && escape_pressed()) answer = {Answer::kLeft, -1};
    if (answer.answer != Answer::kNone) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
  return answer;
}

}  // namespace weftlight
