#include <cctype>
#include <string>

#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/draft/closest_weave_notice.h"

namespace weftlight::views {
namespace {

std::string sentence(std::string words) {
  if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words + ".";
}

std::string offer(const ClosestWeave& n) {
  if (n.is_there) return "Nothing that it weaves comes nearer than what is there.";
  if (n.wrong == 0) return "It weaves it all with other numbers of shafts and treadles.";
  const std::string crossings = std::to_string(n.wrong) + (n.wrong == 1 ? " crossing" : " crossings");
  return "The nearest that it weaves differs in " + crossings + ".";
}

/// "Take 9 shafts"; empty where no loom is larger in one thing alone.
std::string larger(const PanelContext& c) {
  const Draft &requested = c.view.rejected_edit->requested->draft, &d = c.design.draft;
  const auto take = [](int n, const char* what) { return "Take " + std::to_string(n) + " " + what; };
  if (requested.shafts > d.shafts) return take(requested.shafts, "shafts");
  return requested.treadles > d.treadles ? take(requested.treadles, "treadles") : std::string();
}

void draw_card(PanelContext& c, const ClosestWeave& n) {
  push_font(c.style.font.bold);
  ImGui::TextUnformatted(sentence(n.why).c_str());
  ImGui::PopFont();
  muted_text(c, offer(n));
  ImGui::Dummy({0, c.style.px(2)});
  if (!n.is_there) {
    if (text_button(c, "nearest.see", "See the nearest", "It is shown in the draft, and can be taken or left"))
      c.wanted.add_action("nearest");
    ImGui::SameLine();
  }
  if (const std::string words = larger(c); !words.empty()) {
    if (text_button(c, "nearest.larger", words.c_str(), "What was painted, on a larger loom"))
      c.wanted.add_action("larger_loom");
    ImGui::SameLine();
  }
  ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.muted);
  if (text_button(c, "nearest.leave", "Leave it", "The draft stays as it is"))
    c.wanted.change_view([](DocumentView& v) { v.rejected_edit.reset(); });
  ImGui::PopStyleColor();
}

}  // namespace

void draw_closest_weave_notice(PanelContext& c, ImVec2 min, ImVec2 max) {
  if (!c.view.rejected_edit || !c.view.rejected_edit->nearest) return;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, c.style.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {c.style.px(16), c.style.px(12)});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, c.style.color.raised);
  ImGui::PushStyleColor(ImGuiCol_Border, c.style.color.warn);
  ImGui::SetNextWindowPos({(min.x + max.x) / 2, max.y - c.style.px(18)}, ImGuiCond_Always, {0.5f, 1});
  ImGui::Begin("ClosestWeave", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  draw_card(c, *c.view.rejected_edit->nearest);
  ImGui::End();
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar(3);
}

}  // namespace weftlight::views
