// The weave of a new draft: the list, its numbers, and the drawdown that they make.

#include <imgui.h>

#include <algorithm>

#include "draft/drawdown.h"
#include "ui/widgets.h"
#include "views/common/cell_image.h"
#include "views/dialogs/dialog_parts.h"

namespace weftlight::views {
namespace {

constexpr float kListWidth = 176, kHeight = 428, kColumn = 320, kCell = 8;  // pixels at 96 dpi
constexpr int kShownEnds = 40, kShownPicks = 24;

void draw_list(PanelContext& c, WeavePrompt& p) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, c.style.color.panel);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {c.style.px(8), c.style.px(6)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {c.style.px(8), c.style.px(4)});
  ImGui::BeginChild("weaves", {c.style.px(kListWidth), c.style.px(kHeight)}, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding);
  for (int i = 0; i < static_cast<int>(weaves().size()); ++i) {
    const Weave& weave = weaves()[static_cast<size_t>(i)];
    if (ImGui::Selectable(weave.name, i == p.weave) && i != p.weave) {
      p.weave = i;
      p.numbers = first_numbers(weave);
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
      const int column = c.work.end1_right ? kShownEnds - 1 - end : end;
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

DialogAnswer draw_weave_prompt(PanelContext& c, WeavePrompt& p) {
  heading(c, "New draft");
  draw_list(c, p);
  ImGui::SameLine(0, c.style.px(16));
  ImGui::BeginChild("weave", {c.style.px(kColumn), c.style.px(kHeight)});
  const Weave& weave = weaves()[static_cast<size_t>(p.weave)];
  draw_cells(c, weave.make(p.numbers, {std::min(p.ends, kShownEnds), std::min(p.picks, kShownPicks)}));
  ImGui::Dummy({0, c.style.px(2)});
  ImGui::PushTextWrapPos(c.style.px(kColumn));
  muted_text(c, weave.words);
  ImGui::PopTextWrapPos();
  for (size_t i = 0; i < p.numbers.size(); ++i)
    if (const WeaveNumber& n = weave.numbers[i]; n.label != nullptr)
      number(c, (std::string("weave.") + n.label).c_str(), n.label, p.numbers[i], n.min, n.max);
  number(c, "weave.ends", "Ends", p.ends, 1, kMaxThreads);
  number(c, "weave.picks", "Picks", p.picks, 1, kMaxThreads);
  ImGui::EndChild();
  return answered(draw_buttons(c, {"Create", "Cancel"}, true));
}

}  // namespace weftlight::views
