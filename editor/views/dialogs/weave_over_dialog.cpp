// A weave over the chosen threads of the draft: the list, its numbers, and the draft itself, which follows while they
// change. Cancel gives back what was there.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <charconv>
#include <memory>

#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/dialogs/dialog_parts.h"

namespace weftlight::views {
namespace {

constexpr float kListWidth = 190, kHeight = 360, kColumn = 300;  // pixels at 96 dpi

const WeaveKind& kind_of(const WeaveOverPrompt& p) { return weave_kinds()[static_cast<size_t>(p.kind)]; }

/// True when another was chosen.
bool draw_kinds(PanelContext& c, WeaveOverPrompt& p) {
  const int before = p.kind;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, c.style.color.panel);
  begin_padded_child("kinds", {c.style.px(kListWidth), c.style.px(kHeight)});
  std::string family;
  for (int i = 0; i < static_cast<int>(weave_kinds().size()); ++i) {
    const WeaveKind& kind = weave_kinds()[static_cast<size_t>(i)];
    if (family != kind.family) muted_text(c, family = kind.family);
    ImGui::PushID(kind.id);
    if (ImGui::Selectable((std::string("  ") + kind.name).c_str(), i == p.kind)) p.kind = i;
    ImGui::PopID();
    c.map.add_item(std::string("over:") + kind.id);
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
  return p.kind != before;
}

/// True when `value` is another.
bool draw_value(PanelContext& c, const draft::WeaveNumber& n, std::string& value) {
  const std::string id = std::string("over.").append(n.id), before = value;
  if (n.kind == NumberKind::kCount) {
    int count = n.low;
    std::from_chars(value.data(), value.data() + value.size(), count);
    number(c, id.c_str(), n.label, count, n.low, n.high);
    value = std::to_string(count);
    return value != before;
  }
  row_label(c, n.label, n.words);
  ImGui::SetNextItemWidth(c.style.px(190));
  if (n.kind == NumberKind::kText) {
    ImGui::PushID(n.id);
    ImGui::InputText("##text", &value);
    ImGui::PopID();
    c.map.add_item(id);
    return value != before;
  }
  if (begin_combo(c, id.c_str(), value.c_str())) {
    for (const char* choice : n.choices) {
      if (ImGui::Selectable(choice, value == choice)) value = choice;
      c.map.add_item(id + ":" + choice);
    }
    end_combo();
  }
  return value != before;
}

bool draw_values(PanelContext& c, WeaveOverPrompt& p) {
  bool other = false;
  for (const draft::WeaveNumber& n : kind_of(p).numbers)
    for (auto& [key, value] : p.use.values)
      if (key == n.id) other |= draw_value(c, n, value);
  return other;
}

/// All steps of the dialog are one step of undo, each made anew from the draft that it found.
MaybeEdit follow(WeaveOverPrompt& p) {
  p.use.weave = kind_of(p).id;
  Made made = with_weave(*p.base, p.use);
  p.why = std::move(made.why);
  return Edit{std::string("Weave ").append(kind_of(p).name),
              [next = std::make_shared<const Design>(std::move(made.design))](const Design&) { return *next; },
              p.stroke};
}

}  // namespace

DialogAnswer draw_weave_over(PanelContext& c, WeaveOverPrompt& p) {
  DialogAnswer answer;
  heading(c, p.whole ? "Weave over the draft" : "Weave over the selected threads");
  bool other = draw_kinds(c, p);
  if (other || p.use.values.empty()) {
    p.use.values = complete_values(kind_of(p), {});
    other = true;
  }
  ImGui::SameLine(0, c.style.px(16));
  ImGui::BeginChild("numbers", {c.style.px(kColumn), c.style.px(kHeight)});
  ImGui::PushTextWrapPos(c.style.px(kColumn));
  muted_text(c, kind_of(p).words);
  ImGui::PopTextWrapPos();
  other |= draw_values(c, p);
  if (other) answer.edit = follow(p);
  ImGui::Dummy({0, c.style.px(4)});
  ImGui::PushTextWrapPos(c.style.px(kColumn));
  muted_text(c, p.why);
  ImGui::PopTextWrapPos();
  ImGui::EndChild();
  const DialogAnswer button = answered(draw_buttons(c, {"Keep", "Cancel"}, true));
  answer.answer = button.answer, answer.button = button.button;
  return answer;
}

MaybeEdit given_back(const WeaveOverPrompt& p) {
  return Edit{"Weave", [base = p.base](const Design&) { return *base; }, p.stroke};
}

}  // namespace weftlight::views
