// The nearest that the loom weaves to what was painted: the draft shows it, its wrong crossings are marked there and
// listed here. Left, it gives back what was there.

#include <imgui.h>

#include <algorithm>

#include "analysis/difference.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/dialogs/dialog_parts.h"

namespace weftlight::views {
namespace {

constexpr float kWidth = 300;  // pixels at 96 dpi
constexpr int kShownPlaces = 9;

void draw_places(PanelContext& c, const ClosestWeave& n) {
  const int places = static_cast<int>(n.places.size());
  const float line = ImGui::GetTextLineHeightWithSpacing();
  ImGui::BeginChild("places",
                    {c.style.px(kWidth), static_cast<float>(std::min(places, kShownPlaces)) * line + c.style.px(4)});
  for (int i = 0; i < places; ++i) {
    const CellRect& at = n.places[static_cast<size_t>(i)];
    ImGui::PushID(i);
    if (ImGui::Selectable(analysis::place_text(at).c_str(), i == c.view.place))
      c.wanted.change_view([i, at](DocumentView& v) { show_place(v, i, at); });
    ImGui::PopID();
    c.map.add_item("nearest.place:" + std::to_string(i + 1));
  }
  ImGui::EndChild();
}

}  // namespace

DialogAnswer draw_closest_weave(PanelContext& c, ClosestWeavePrompt& p) {
  const ClosestWeave& n = *p.nearest;
  heading(c, "The nearest that the loom weaves");
  ImGui::PushTextWrapPos(c.style.px(kWidth));
  muted_text(c, "What was painted is too much for it: " + n.why + ".");
  const int64_t all = int64_t{n.differing.rows()} * n.differing.cols();
  ImGui::TextUnformatted((std::to_string(n.wrong) + " of " + std::to_string(all) +
                          (n.wrong == 1 ? " crossings is not as you painted it; it is marked."
                                        : " crossings are not as you painted them; they are marked."))
                             .c_str());
  c.map.add_item("nearest.wrong:" + std::to_string(n.wrong));
  ImGui::PopTextWrapPos();
  draw_places(c, n);
  return answered(draw_buttons(c, {"Take the nearest", "Keep what was"}, true));
}

MaybeEdit given_back(const ClosestWeavePrompt& p) {
  return Edit{"ClosestWeave", [base = p.base](const Design&) { return *base; }, p.stroke};
}

}  // namespace weftlight::views
