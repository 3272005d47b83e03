// The weave of a new draft: the list of weaves, the parameters, and a preview of the drawdown.

#include <imgui.h>

#include <algorithm>

#include "base/text.h"
#include "draft/drawdown.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/common/cell_image.h"
#include "views/dialogs/dialog_parts.h"

namespace weftlight::views {

using base::arg, base::fill, base::mark, base::tr;
using design::Design;
using draft::BitMatrix, draft::Face, draft::System, draft::drawdown, draft::kMaxThreads;
using ui::muted_text;
using weaves::ClothSize, weaves::GeneratedWeave, weaves::WeaveKind, weaves::allowed_values, weaves::new_draft,
    weaves::repeat_of, weaves::weave_kinds, weaves::whole_repeats;

namespace {

constexpr float kListWidth = 176, kHeight = 428, kColumn = 320, kCell = 8;  // pixels at 96 dpi
constexpr int kShownEnds = 40, kShownPicks = 24;

const WeaveKind& kind_of(const WeavePrompt& p) { return weave_kinds()[static_cast<size_t>(p.kind)]; }

/// After a change of the weave: rounds the size to whole repeats, unless it was typed.
void update_size(WeavePrompt& p) {
  p.repeat = repeat_of(kind_of(p), p.values);
  if (p.own_size) return;
  const ClothSize whole = whole_repeats(p.repeat, {p.ends, p.picks});
  p.ends = whole.ends, p.picks = whole.picks;
}

/// Also tells if the size cuts off the last repeat.
void draw_repeat(PanelContext& c, const WeavePrompt& p) {
  if (p.repeat.ends <= 0 || p.repeat.picks <= 0) return;
  const bool cut = p.ends % p.repeat.ends != 0 || p.picks % p.repeat.picks != 0;
  const char* text =
      cut ? tr("Repeat: {ends} \xC3\x97 {picks}; the last one is cut off") : tr("Repeat: {ends} \xC3\x97 {picks}");
  muted_text(c, fill(text, arg("ends", p.repeat.ends), arg("picks", p.repeat.picks)));
}

/// The corner at end 1 and pick 1, in the colours of the draft.
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
      const int row = c.settings.pick1_bottom ? kShownPicks - 1 - pick : pick;
      const ImVec2 a{at.x + side * static_cast<float>(column), at.y + side * static_cast<float>(row)};
      const bool up = warp_on_top(cells, Face::kFront, end, pick);
      // A one-pixel gap along the thread on top shows which one it is if both have the same colour.
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

WeavePrompt prompt_for(int kind, ClothSize about) {
  WeavePrompt p;
  p.kind = kind, p.ends = about.ends, p.picks = about.picks;
  p.values = allowed_values(kind_of(p), {});
  update_size(p);
  return p;
}

DialogResult draw_weave_prompt(PanelContext& c, WeavePrompt& p) {
  heading(c, tr("New draft"));
  if (draw_weave_list(c, p.kind, kListWidth, kHeight)) {
    p.values = allowed_values(kind_of(p), {});
    update_size(p);
  }
  ImGui::SameLine(0, c.style.px(16));
  ImGui::BeginChild("weave", {c.style.px(kColumn), c.style.px(kHeight)});
  const WeaveKind& kind = kind_of(p);
  const GeneratedWeave made = new_draft(kind, p.values, {std::min(p.ends, kShownEnds), std::min(p.picks, kShownPicks)});
  draw_cells(c, made.design);
  ImGui::Dummy({0, c.style.px(2)});
  ImGui::PushTextWrapPos(c.style.px(kColumn));
  muted_text(c, made.note.empty() ? tr(kind.description) : made.note);
  ImGui::PopTextWrapPos();
  if (draw_weave_numbers(c, kind, p.values)) update_size(p);
  const int ends = p.ends, picks = p.picks;
  number(c, "weave.ends", tr("Ends"), p.ends, 1, kMaxThreads);
  number(c, "weave.picks", tr("Picks"), p.picks, 1, kMaxThreads);
  p.own_size = p.own_size || ends != p.ends || picks != p.picks;
  draw_repeat(c, p);
  ImGui::EndChild();
  return dialog_result(draw_buttons(c, {mark("Create"), mark("Cancel")}, true));
}

}  // namespace weftlight::views
