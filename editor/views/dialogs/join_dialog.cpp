// The draft joined with another one: which threads take turns, and how many. The draft follows the choices. Cancel
// restores it.

#include <imgui.h>

#include <memory>
#include <utility>

#include "base/text.h"
#include "ui/widgets.h"
#include "views/dialogs/prompts.h"

namespace weftlight::views {

using base::mark, base::tr;
using design::Design;
using session::Edit, session::MaybeEdit;
using ui::fitted, ui::muted_text, ui::segmented;
using weaves::JoinBy, weaves::Joining, weaves::joined_drafts;

namespace {

constexpr float kWidth = 400;  // pixels at 96 dpi
constexpr int kMaxInTurn = 1000;

/// Every change in the dialog starts again from the draft as it was, and all of them are one undo step.
MaybeEdit preview_edit(JoinPrompt& p) {
  p.shown = true;
  base::Result<Design> made = joined_drafts(*p.base, *p.other, p.joining);
  p.why = problem_of(made);
  return Edit{
      tr("Join with another draft"),
      [next = made ? std::make_shared<const Design>(std::move(*made)) : p.base](const Design&) { return *next; },
      p.stroke};
}

/// What the chosen way makes.
const char* explanation(JoinBy by) {
  switch (by) {
    case JoinBy::kEnds:
      return tr("Ends of both in turn; each pick weaves both drafts' picks of its number.");
    case JoinBy::kPicks:
      return tr("Picks of both in turn, each weaving all ends as its own draft does.");
    case JoinBy::kLayers:
      return tr("Ends and picks in turn: this cloth lies above the other, as in double cloth.");
  }
  return "";
}

}  // namespace

DialogResult draw_prompt(PanelContext& c, JoinPrompt& p) {
  heading(c, tr("Join with another draft"));
  muted_text(c, fitted(p.name, c.style.px(kWidth)));
  constexpr const char* kWays[] = {mark("Ends"), mark("Picks"), mark("Layers")};
  const Joining before = p.joining;
  int way = static_cast<int>(p.joining.by);
  segmented(c, "join.by", kWays, way, c.style.px(kWidth));
  p.joining.by = static_cast<JoinBy>(way);
  ImGui::PushTextWrapPos(c.style.px(kWidth));
  muted_text(c, explanation(p.joining.by));
  ImGui::PopTextWrapPos();
  begin_here();
  number(c, "join.first", tr("This draft"), p.joining.first, 1, kMaxInTurn);
  number(c, "join.second", tr("The other"), p.joining.second, 1, kMaxInTurn);
  MaybeEdit edit;
  if (!p.shown || !(before == p.joining)) edit = preview_edit(p);
  ImGui::PushTextWrapPos(c.style.px(kWidth));
  ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.warn);
  ImGui::TextUnformatted(p.why.c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  if (!p.why.empty()) c.map.add_item("join.why");
  return edited(std::move(edit), dialog_result(draw_buttons(c, {mark("Join"), mark("Cancel")}, true, p.why.empty())));
}

MaybeEdit restored(const JoinPrompt& p) {
  return Edit{tr("Join with another draft"), [base = p.base](const Design&) { return *base; }, p.stroke};
}

}  // namespace weftlight::views
