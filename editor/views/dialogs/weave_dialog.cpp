// The weave of a new draft: the list, its numbers, and the drawdown that they make.

#include <imgui.h>

#include <algorithm>

#include "draft/drawdown.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/common/cell_image.h"
#include "views/dialogs/dialog_parts.h"

namespace weftlight::views {
namespace {

constexpr float kListWidth = 176, kHeight = 428, kColumn = 320, kCell = 8;  // pixels at 96 dpi
constexpr int kShownEnds = 40, kShownPicks = 24;

const Weave& weave_of(const WeavePrompt& p) { return weaves()[static_cast<size_t>(p.weave)]; }

/// Another weave or other numbers: the size stays near and holds whole repeats, unless it was typed.
void follow_repeat(WeavePrompt& p) {
  p.numbers = valid_numbers(weave_of(p), p.numbers);
  p.repeat = repeat_of(weave_of(p), p.numbers);
  if (p.own_size) return;
  const ClothSize whole = whole_repeats(p.repeat, {p.ends, p.picks});
  p.ends = whole.ends, p.picks = whole.picks;
}

/// True when it was changed.
bool draw_number(PanelContext& c, WeavePrompt& p, size_t i) {
  const session::WeaveNumber& n = weave_of(p).numbers[i];
  const std::string id = std::string("weave.").append(n.label);
  const int before = p.numbers[i];
  if (n.choices == nullptr) {
    number(c, id.c_str(), n.label, p.numbers[i], n.min, n.max);
    return p.numbers[i] != before;
  }
  row_label(c, n.label, "Only what makes an even satin is offered: steps that share no factor with the shafts");
  ImGui::SetNextItemWidth(c.style.px(140));
  if (begin_combo(c, id.c_str(), std::to_string(before).c_str())) {
    for (const int choice : n.choices(p.numbers)) {
      const std::string word = std::to_string(choice);
      if (ImGui::Selectable(word.c_str(), choice == before)) p.numbers[i] = choice;
      c.map.add_item(id + ":" + word);
    }
    end_combo();
  }
  return p.numbers[i] != before;
}

/// Says what a size that was typed cuts off.
void draw_repeat(PanelContext& c, const WeavePrompt& p) {
  if (p.repeat.ends <= 0 || p.repeat.picks <= 0) return;
  std::string text = "One repeat is " + std::to_string(p.repeat.ends) + " \xC3\x97 " + std::to_string(p.repeat.picks);
  if (p.ends % p.repeat.ends != 0 || p.picks % p.repeat.picks != 0) text += "; the last one is cut off";
  muted_text(c, text);
}

void draw_list(PanelContext& c, WeavePrompt& p) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, c.style.color.panel);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {c.style.px(8), c.style.px(6)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {c.style.px(8), c.style.px(4)});
  begin_padded_child("weaves", {c.style.px(kListWidth), c.style.px(kHeight)});
  for (int i = 0; i < static_cast<int>(weaves().size()); ++i) {
    const Weave& weave = weaves()[static_cast<size_t>(i)];
    if (ImGui::Selectable(weave.name, i == p.weave) && i != p.weave) {
      p.weave = i;
      p.numbers = first_numbers(weave);
      follow_repeat(p);
    }
    c.map.add_item(std::string("weave:") + weave.name);
  }
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
}

/// The corner of end 1 and pick 1, in the draft's own colours.
void draw_cells(PanelContext& c, const Design& design) {
  const BitMatrix cells = drawdown(design.draft);
  const auto warp = thread_colors(design.draft, System::kWarp), weft = thread_colors(design.draft, System::kWeft);
  const float side = c.style.px(kCell);
  const ImVec2 at = ImGui::GetCursorScreenPos(), size{kShownEnds * side, kShownPicks * side};
  ImDrawList* dl = ImGui::GetWindowDrawList();
  dl->AddRectFilled(at, {at.x + size.x, at.y + size.y}, c.style.color.panel);
  for (int pick = 0; pick < std::min(kShownPicks, design.draft.picks()); ++pick)
    for (int end = 0; end < std::min(kShownEnds, design.draft.ends()); ++end) {
      const int column = c.settings.end1_right ? kShownEnds - 1 - end : end;
      const ImVec2 a{at.x + side * static_cast<float>(column), at.y + side * static_cast<float>(pick)};
      const bool up = warp_on_top(cells, Face::kFront, end, pick);
      // A hairline's room along the thread on top shows which one it is where both have one colour.
      const ImVec2 gap = up ? ImVec2{1, 0} : ImVec2{0, 1};
      dl->AddRectFilled(a, {a.x + side, a.y + side}, c.style.color.line_strong);
      dl->AddRectFilled(a, {a.x + side - gap.x, a.y + side - gap.y},
                        up ? warp[static_cast<size_t>(end)] : weft[static_cast<size_t>(pick)]);
    }
  dl->AddRect(at, {at.x + size.x, at.y + size.y}, c.style.color.line);
  ImGui::Dummy(size);
  c.map.add_item("weave.drawdown");
}

}  // namespace

WeavePrompt prompt_for(int weave, ClothSize about) {
  WeavePrompt p{weave, first_numbers(weaves()[static_cast<size_t>(weave)]), about.ends, about.picks, {0, 0}, false};
  follow_repeat(p);
  return p;
}

DialogAnswer draw_weave_prompt(PanelContext& c, WeavePrompt& p) {
  heading(c, "New draft");
  draw_list(c, p);
  ImGui::SameLine(0, c.style.px(16));
  ImGui::BeginChild("weave", {c.style.px(kColumn), c.style.px(kHeight)});
  const Weave& weave = weave_of(p);
  draw_cells(c, weave.make(p.numbers, {std::min(p.ends, kShownEnds), std::min(p.picks, kShownPicks)}));
  ImGui::Dummy({0, c.style.px(2)});
  ImGui::PushTextWrapPos(c.style.px(kColumn));
  muted_text(c, weave.words);
  ImGui::PopTextWrapPos();
  bool other = false;
  for (size_t i = 0; i < p.numbers.size(); ++i)
    if (weave.numbers[i].label != nullptr) other |= draw_number(c, p, i);
  if (other) follow_repeat(p);
  const int ends = p.ends, picks = p.picks;
  number(c, "weave.ends", "Ends", p.ends, 1, kMaxThreads);
  number(c, "weave.picks", "Picks", p.picks, 1, kMaxThreads);
  p.own_size = p.own_size || ends != p.ends || picks != p.picks;
  draw_repeat(c, p);
  ImGui::EndChild();
  return answered(draw_buttons(c, {"Create", "Cancel"}, true));
}

}  // namespace weftlight::views
