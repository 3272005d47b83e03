// A weave over the selected threads of the draft: the list of weaves and the parameters. The draft follows the choices.
// Cancel restores it.

#include <imgui.h>

#include <memory>
#include <utility>

#include "base/text.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/dialogs/prompts.h"

namespace weftlight::views {

using base::arg, base::fill, base::mark, base::tr;
using design::Design;
using session::Edit, session::MaybeEdit;
using ui::begin_list, ui::muted_text;
using weaves::GeneratedWeave, weaves::WeaveKind, weaves::allowed_values, weaves::cut_repeat_note, weaves::weave_kinds,
    weaves::with_weave;

namespace {

constexpr float kListWidth = 190, kHeight = 360, kColumn = 300;  // pixels at 96 dpi

const WeaveKind& kind_of(const WeaveOverPrompt& p) { return weave_kinds()[static_cast<size_t>(p.kind)]; }

/// Every change in the dialog starts again from the draft as it was, and all of them are one undo step.
MaybeEdit preview_edit(WeaveOverPrompt& p) {
  p.use.weave = kind_of(p).id;
  base::Result<GeneratedWeave> made = with_weave(*p.base, p.use);
  p.refused = !made;
  p.why = made ? std::move(made->note) : problem_of(made);
  if (made) {
    const std::string cut = cut_repeat_note(kind_of(p), p.use.values, {p.use.ends, p.use.picks});
    p.why += (cut.empty() || p.why.empty() ? "" : "\n") + cut;
  }
  return Edit{
      fill(tr("Apply weave {weave}"), arg("weave", tr(kind_of(p).name))),
      [next = made ? std::make_shared<const Design>(std::move(made->design)) : p.base](const Design&) { return *next; },
      p.stroke};
}

}  // namespace

DialogResult draw_prompt(PanelContext& c, WeaveOverPrompt& p) {
  MaybeEdit edit;
  heading(c, p.whole ? tr("Weave over the draft") : tr("Weave over the selected threads"));
  bool changed = draw_weave_list(c, p.kind, p.typed, kListWidth, kHeight);
  if (changed || p.use.values.empty()) {
    p.use.values = allowed_values(kind_of(p), {});
    changed = true;
  }
  ImGui::SameLine(0, c.style.px(16));
  begin_list("numbers", {c.style.px(kColumn) + ImGui::GetStyle().ScrollbarSize, c.style.px(kHeight)});
  ImGui::PushTextWrapPos(c.style.px(kColumn));
  muted_text(c, tr(kind_of(p).description));
  ImGui::PopTextWrapPos();
  changed |= draw_weave_numbers(c, kind_of(p), p.use.values);
  if (changed) edit = preview_edit(p);
  ImGui::Dummy({0, c.style.px(4)});
  ImGui::PushTextWrapPos(c.style.px(kColumn));
  ImGui::PushStyleColor(ImGuiCol_Text, p.refused ? c.style.color.warn : c.style.color.muted);
  ImGui::TextUnformatted(p.why.c_str());
  if (p.refused) c.map.add_item("weave.refused");
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ImGui::EndChild();
  const bool possible = !p.refused && !found_weaves(p.typed).empty();
  return edited(std::move(edit), dialog_result(draw_buttons(c, {mark("Apply"), mark("Cancel")}, true, possible)));
}

MaybeEdit restored(const WeaveOverPrompt& p) {
  return Edit{tr("Weave"), [base = p.base](const Design&) { return *base; }, p.stroke};
}

}  // namespace weftlight::views
