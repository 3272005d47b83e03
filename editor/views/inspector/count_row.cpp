#include "views/inspector/count_row.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <cmath>
#include <cstdio>
#include <optional>

#include "draft/count.h"
#include "draft/fibre.h"
#include "ui/widgets.h"
#include "views/inspector/words_row.h"

namespace weftlight::views {
namespace {

// Round fibres as close as they can lie (hexagons: pi / (2 sqrt 3)).
constexpr double kClosest = 0.907;

/// "29.5", "147", "1330": three figures, or all before the point.
std::string three_figures(double value) {
  char text[32];
  const int after = value >= 100 ? 0 : value >= 10 ? 1 : 2;
  std::snprintf(text, sizeof text, "%.*f", after, value);
  return text;
}

}  // namespace

std::string count_in_words(const Yarn& yarn) {
  const double tex = static_cast<double>(tex_of(yarn));
  if (!(tex > 0)) return "as thick as the draft says";
  std::string text = "Ne " + three_figures(count_of(tex, CountUnit::kNe)) + ", Nm " +
                     three_figures(count_of(tex, CountUnit::kNm)) + ", " +
                     three_figures(count_of(tex, CountUnit::kDenier)) + " den\n";
  if (!(yarn.tex > 0)) return text + "follows the thickness";
  const double share = packing_fraction(yarn);
  if (share > kClosest) return text + "more than fits in its thickness";
  return share > 0 ? text + std::to_string(std::lround(100 * share)) + " % of it is fibre" : text + "set";
}

bool draw_count(const PanelContext& c, Yarn& yarn) {
  row_label(
      c, "Count",
      "How heavy it is, as it is sold: Ne 8/2, Nm 30/2, 16 lea, 150 den, 30 tex. Sets the thickness, which may be "
      "changed after it; empty, the count follows the thickness");
  ImGui::SetNextItemWidth(-FLT_MIN);
  std::string typed = three_figures(static_cast<double>(tex_of(yarn))) + " tex";
  const ImGuiID unread = ImGui::GetID("##count not understood");
  ImGuiStorage& kept = *ImGui::GetStateStorage();
  const bool entered = ImGui::InputText("##count", &typed, ImGuiInputTextFlags_EnterReturnsTrue);
  c.map.add_item("yarn.count");
  if (ImGui::IsItemActivated()) kept.SetBool(unread, false);
  const std::optional<Yarn> spun = entered ? with_count(yarn, typed) : yarn;
  if (!spun) kept.SetBool(unread, true);
  if (kept.GetBool(unread))
    draw_words(c, "Not understood: write Ne 8/2, Nm 30/2, 16 lea, 150 den or 30 tex", c.style.color.error,
               "A number with its unit, after a stroke the plies; 0.1 to 100,000 tex");
  else
    draw_words(
        c, count_in_words(yarn), c.style.color.muted,
        "The same in other units of the trade. Weight, stiffness and yarn to buy go by the count, the picture by "
        "the thickness");
  if (!entered || !spun) return false;
  yarn = *spun;
  return true;
}

}  // namespace weftlight::views
