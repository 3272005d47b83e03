// The list of weaves by family and the parameters of one, shared by both weave dialogs.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <charconv>

#include "base/text.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/dialogs/dialog_parts.h"

namespace weftlight::views {

using base::tr;
using ui::begin_combo, ui::begin_padded_child, ui::end_combo, ui::muted_text, ui::row_label;
using weaves::ParameterKind, weaves::WeaveKind, weaves::WeaveParameter, weaves::WeaveValues, weaves::allowed_values,
    weaves::weave_kinds;

namespace {

/// True if `value` changed.
bool pick_from(PanelContext& c, const std::string& id, const std::vector<std::string>& choices, std::string& value) {
  const std::string before = value;
  if (!begin_combo(c, id.c_str(), tr(value.c_str()))) return false;
  for (const std::string& choice : choices) {
    if (ImGui::Selectable(tr(choice.c_str()), value == choice)) value = choice;
    c.map.add_item(id + ":" + choice);
  }
  end_combo();
  return value != before;
}

bool draw_count(PanelContext& c, const WeaveParameter& n, std::string& value) {
  const std::string before = value;
  int count = n.low;
  std::from_chars(value.data(), value.data() + value.size(), count);
  number(c, std::string("weave.").append(n.id).c_str(), tr(n.label), count, n.low, n.high);
  value = std::to_string(count);
  return value != before;
}

bool draw_text(PanelContext& c, const WeaveParameter& n, std::string& value) {
  const std::string before = value;
  ImGui::PushID(n.id);
  ImGui::InputText("##text", &value);
  ImGui::PopID();
  c.map.add_item(std::string("weave.").append(n.id));
  return value != before;
}

std::vector<std::string> choices_of(const WeaveParameter& n, const WeaveValues& values) {
  std::vector<std::string> choices(n.choices.begin(), n.choices.end());
  if (n.allowed)
    for (const int one : n.allowed(n, values)) choices.push_back(std::to_string(one));
  return choices;
}

bool draw_value(PanelContext& c, const WeaveParameter& n, const WeaveValues& all, std::string& value) {
  if (n.kind == ParameterKind::kCount && !n.allowed) return draw_count(c, n, value);
  row_label(c, tr(n.label), tr(n.tip));
  ImGui::SetNextItemWidth(c.style.px(n.allowed ? 140 : 190));
  if (n.kind == ParameterKind::kText) return draw_text(c, n, value);
  return pick_from(c, std::string("weave.").append(n.id), choices_of(n, all), value);
}

}  // namespace

bool draw_weave_list(PanelContext& c, int& chosen, float width, float height) {
  const int before = chosen;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, c.style.color.panel);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {c.style.px(8), c.style.px(6)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {c.style.px(8), c.style.px(4)});
  begin_padded_child("weaves", {c.style.px(width), c.style.px(height)});
  std::string family;
  for (int i = 0; i < static_cast<int>(weave_kinds().size()); ++i) {
    const WeaveKind& kind = weave_kinds()[static_cast<size_t>(i)];
    if (family != kind.family) muted_text(c, tr((family = kind.family).c_str()));
    const std::string id = std::string("weave:") + kind.id;
    if (list_row(c, id.c_str(), (std::string("  ") + tr(kind.name)).c_str(), i == chosen)) chosen = i;
  }
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
  return chosen != before;
}

bool draw_weave_numbers(PanelContext& c, const WeaveKind& kind, WeaveValues& values) {
  bool changed = false;
  for (const WeaveParameter& n : kind.parameters)
    for (auto& [key, value] : values)
      if (key == n.id) changed |= draw_value(c, n, values, value);
  if (changed) values = allowed_values(kind, values);
  return changed;
}

}  // namespace weftlight::views
