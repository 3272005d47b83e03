#include "views/dialogs/dialog_parts.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "ui/imgui_compat.h"
#include "ui/keyboard.h"
#include "ui/widgets.h"

namespace weftlight::views {

using base::tr;
using ui::blend, ui::content_right, ui::key_pressed, ui::push_font, ui::row_label, ui::text_button;

namespace {

bool enter_pressed() { return key_pressed(ImGuiKey_Enter, false); }

bool primary_button(PanelContext& c, const char* id, const char* label, bool possible) {
  ImGui::BeginDisabled(!possible);
  ImGui::PushStyleColor(ImGuiCol_Button, c.style.color.accent);
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, blend(c.style.color.accent, c.style.color.text, 0.15f));
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, blend(c.style.color.accent, c.style.color.text, 0.3f));
  ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.paper);
  const bool pressed = text_button(c, id, label, nullptr);
  ImGui::PopStyleColor(4);
  ImGui::EndDisabled();
  return pressed;
}

}  // namespace

int draw_buttons(PanelContext& c, const std::vector<std::string>& labels, bool by_enter, bool possible, int primary) {
  const ImGuiStyle& s = ImGui::GetStyle();
  float width = -s.ItemSpacing.x;
  for (const std::string& l : labels)
    width += ImGui::CalcTextSize(tr(l.c_str())).x + 2 * s.FramePadding.x + s.ItemSpacing.x;
  ImGui::Dummy({0, c.style.px(6)});
  ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), content_right() - width));
  int pressed = -1;
  for (int i = static_cast<int>(labels.size()) - 1; i >= 0; --i) {
    const std::string id = "dialog:" + labels[static_cast<size_t>(i)];
    const char* label = tr(labels[static_cast<size_t>(i)].c_str());
    if (i == primary ? primary_button(c, id.c_str(), label, possible) : text_button(c, id.c_str(), label, nullptr))
      pressed = i;
    if (i > 0) ImGui::SameLine();
  }
  const bool entered = by_enter && possible && enter_pressed() && !takes_enter(c.map);
  return pressed < 0 && entered ? primary : pressed;
}

DialogResult dialog_result(int button, int cancel_button) {
  if (button < 0) return {};
  return {button == cancel_button ? DialogOutcome::kCancelled : DialogOutcome::kDone, button, {}};
}

DialogResult edited(MaybeEdit edit, DialogResult buttons) {
  buttons.edit = std::move(edit);
  return buttons;
}

unsigned field_of_number(const char* label) {
  // The field in the group that ImGui makes of it and its two buttons.
  ImGui::PushID(label);
  const ImGuiID field = ImGui::GetID("");
  ImGui::PopID();
  return field;
}

void heading(PanelContext& c, const std::string& text) {
  push_font(c.style.font.bold);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopFont();
  ImGui::Dummy({0, c.style.px(2)});
}

void begin_here() {
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
}

void number(PanelContext& c, const char* id, const char* label, int& value, int min, int max, const char* tip) {
  row_label(c, label, tip);
  push_font(c.style.font.mono);
  ImGui::SetNextItemWidth(c.style.px(140));
  ImGui::PushID(id);
  ImGui::InputInt("##n", &value, 1, 10);
  ImGui::PopFont();
  c.map.add_field(id, field_of_number("##n"));
  ImGui::PopID();
  value = std::clamp(value, min, max);
}

bool scaled_slider(const PanelContext& c, ui::SliderSpec spec, float scale, float& kept) {
  for (float* limit : {&spec.min, &spec.max, &spec.figure_min, &spec.figure_max}) *limit *= scale;
  float shown = kept * scale;
  if (!ui::slider(c, spec, shown)) return false;
  kept = shown / scale;
  return true;
}

}  // namespace weftlight::views
