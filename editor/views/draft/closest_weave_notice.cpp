#include "views/draft/closest_weave_notice.h"

#include <string>

#include "base/text.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {

using base::arg, base::fill, base::tr, base::tr_n;
using draft::Draft;
using session::ClosestWeave, session::DocumentView;
using ui::muted_text, ui::push_font, ui::text_button;

namespace {

std::string offer(const ClosestWeave& n) {
  if (n.is_there) return tr("The draft is already the closest weave.");
  if (n.wrong == 0) return tr("It can be woven with another number of shafts and treadles.");
  return fill(tr_n("The closest weave differs in {count} crossing.", "The closest weave differs in {count} crossings.",
                   n.wrong),
              arg("count", n.wrong));
}

/// "Use 9 shafts". Empty if one larger number is not enough.
std::string larger(const Draft& d, const Draft& requested) {
  const int shafts = requested.shafts, treadles = requested.treadles;
  if (shafts > d.shafts) return fill(tr_n("Use {count} shaft", "Use {count} shafts", shafts), arg("count", shafts));
  if (treadles <= d.treadles) return {};
  return fill(tr_n("Use {count} treadle", "Use {count} treadles", treadles), arg("count", treadles));
}

void draw_card(PanelContext& c, const RejectedEdit& rejected) {
  const ClosestWeave& n = *rejected.closest;
  push_font(c.style.font.bold);
  ImGui::TextUnformatted(fill(tr("This loom cannot weave the edit: {reason}."), arg("reason", n.why)).c_str());
  ImGui::PopFont();
  muted_text(c, offer(n));
  ImGui::Dummy({0, c.style.px(2)});
  if (!n.is_there) {
    if (text_button(c, "closest.see", tr("Show closest weave"),
                    tr("Shows it in the draft; you can then use it or cancel")))
      c.wanted.add_action("closest_weave");
    ImGui::SameLine();
  }
  if (const std::string words = larger(c.design.draft, rejected.requested->draft); !words.empty()) {
    if (text_button(c, "closest.larger", words.c_str(), tr("Apply the edit with more shafts or treadles")))
      c.wanted.add_action("larger_loom");
    ImGui::SameLine();
  }
  ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.muted);
  if (text_button(c, "closest.leave", tr("Dismiss"), tr("Leave the draft as it is")))
    c.wanted.change_view([](DocumentView& v) { v.rejected_edit.reset(); });
  ImGui::PopStyleColor();
}

}  // namespace

void draw_closest_weave_notice(PanelContext& c, const std::optional<RejectedEdit>& rejected, ImVec2 min, ImVec2 max) {
  if (!rejected || !rejected->closest) return;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, c.style.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {c.style.px(16), c.style.px(12)});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, c.style.color.raised);
  ImGui::PushStyleColor(ImGuiCol_Border, c.style.color.warn);
  ImGui::SetNextWindowPos({(min.x + max.x) / 2, max.y - c.style.px(18)}, ImGuiCond_Always, {0.5f, 1});
  ImGui::Begin("Closest weave", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  draw_card(c, *rejected);
  ImGui::End();
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar(3);
}

}  // namespace weftlight::views
