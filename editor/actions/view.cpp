// How the draft and the cloth are seen.

#include <utility>

#include "actions/action_parts.h"

namespace weftlight::actions {
namespace {

void add_drawdown_looks(Actions& all) {
  constexpr std::pair<const char*, const char*> kLooks[] = {{"look.threads", "Drawdown as threads"},
                                                            {"look.color", "Drawdown in colour"},
                                                            {"look.structure", "Drawdown as structure"}};
  for (int i = 0; i < 3; ++i) {
    const auto look = static_cast<DrawdownStyle>(i);
    Action& a =
        add(all, "View", kLooks[i].first, kLooks[i].second, "", [look](Desk& e) { e.work().drawdown_style = look; });
    a.checked = [look](const Desk& e) { return e.work().drawdown_style == look; };
    a.item.group = i == 0;
  }
  Action& back = add(all, "View", "back", "Back of the cloth in the drawdown", "Ctrl+B",
                     [](Desk& e) { e.work().face = e.work().face == Face::kFront ? Face::kBack : Face::kFront; });
  back.checked = [](const Desk& e) { return e.work().face == Face::kBack; };
  Action& right = add(all, "View", "end1_right", "End 1 at the right", "",
                      [](Desk& e) { e.work().end1_right = !e.work().end1_right; });
  right.checked = [](const Desk& e) { return e.work().end1_right; };
}

}  // namespace

void add_view_actions(Actions& all) {
  add(all, "View", "zoom_in", "Larger cells", "Ctrl++",
      [](Desk& e) { e.work().pitch = zoomed_pitch(e.work().pitch, 1); });
  add(all, "View", "zoom_out", "Smaller cells", "Ctrl+-",
      [](Desk& e) { e.work().pitch = zoomed_pitch(e.work().pitch, -1); });
  add(all, "View", "fit", "Fit the draft", "Ctrl+0", [](Desk& e) { e.work().pitch = 0; });
  add_drawdown_looks(all);
  new_group(
      add(all, "View", "reset_view", "Reset the view of the cloth", "Ctrl+Shift+0", [](Desk& e) { e.reset_view(); }));
  add(all, "View", "keep_view", "Keep this view with the draft", "", [](Desk& e) { e.keep_view(); });
  Action& remarks = add(all, "View", "show_remarks", "Remarks on the file", "", [](Desk& e) { e.show_remarks(); });
  remarks.item.group = true;
  add(all, "View", "theme", "Light or dark", "", [](Desk& e) { e.toggle_theme(); });
}

}  // namespace weftlight::actions
