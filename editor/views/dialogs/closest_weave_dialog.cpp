// The closest weave within the loom limits to what was painted. The draft shows it and marks the crossings that differ;
// they are listed here. Cancel restores the draft.

#include <imgui.h>

#include <algorithm>

#include "analysis/difference.h"
#include "base/text.h"
#include "session/editing/follow_document.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/dialogs/prompts.h"

namespace weftlight::views {

using base::arg, base::fill, base::mark, base::tr, base::tr_n;
using design::Design;
using draft::CellRect;
using session::ClosestWeave, session::DocumentView, session::Edit, session::MaybeEdit, session::show_place;
using ui::begin_list, ui::muted_text;

namespace {

constexpr float kWidth = 300;  // pixels at 96 dpi
constexpr int kShownPlaces = 9;

void draw_places(PanelContext& c, ClosestWeavePrompt& p) {
  const ClosestWeave& n = *p.closest;
  const int places = static_cast<int>(n.places.size());
  const float line = ImGui::GetTextLineHeightWithSpacing();
  begin_list("places", {c.style.px(kWidth), static_cast<float>(std::min(places, kShownPlaces)) * line + c.style.px(4)});
  for (int i = 0; i < places; ++i) {
    const CellRect& at = n.places[static_cast<size_t>(i)];
    const std::string id = "closest.place:" + std::to_string(i + 1);
    if (list_row(c, id.c_str(), analysis::region_text(at).c_str(), i == p.place)) {
      p.place = i;
      c.wanted.change_view([i, at](DocumentView& v) { show_place(v, i, at); });
    }
  }
  ImGui::EndChild();
}

}  // namespace

DialogResult draw_prompt(PanelContext& c, ClosestWeavePrompt& p) {
  const ClosestWeave& n = *p.closest;
  heading(c, tr("Closest weave"));
  ImGui::PushTextWrapPos(c.style.px(kWidth));
  muted_text(c, fill(tr("This loom cannot weave the edit: {reason}."), arg("reason", n.why)));
  const int64_t all = int64_t{n.differing.rows()} * n.differing.cols();
  const char* text = tr_n("{count} of {all} crossings differs from your edit; it is marked.",
                          "{count} of {all} crossings differ from your edit; they are marked.", n.wrong);
  ImGui::TextUnformatted(fill(text, arg("count", n.wrong), arg("all", all)).c_str());
  c.map.add_item("closest.wrong:" + std::to_string(n.wrong));
  ImGui::PopTextWrapPos();
  draw_places(c, p);
  return dialog_result(draw_buttons(c, {mark("Use closest weave"), mark("Cancel")}, true));
}

MaybeEdit restored(const ClosestWeavePrompt& p) {
  return Edit{tr("Use closest weave"), [base = p.base](const Design&) { return *base; }, p.stroke};
}

}  // namespace weftlight::views
