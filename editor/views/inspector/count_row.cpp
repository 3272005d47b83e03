#include "views/inspector/count_row.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <cmath>
#include <cstdio>
#include <optional>

#include "analysis/measures.h"
#include "base/decimals.h"
#include "base/text.h"
#include "design/count.h"
#include "design/fibre.h"
#include "design/written_count.h"
#include "ui/widgets.h"
#include "views/inspector/words_row.h"

namespace weftlight::views {

using analysis::MeanThread, analysis::mean_thread;
using base::arg, base::fill, base::tr, base::with_decimal_point;
using design::CountUnit, design::count_of, design::packing_fraction, design::tex_of, design::with_count,
    design::written_count;
using draft::System;
using ui::row_label;

namespace {

// Densest packing of round fibres: pi / (2 sqrt 3).
constexpr double kMaxPacking = 0.907;

/// Three significant figures, or the whole number: "29.5", "147", "1330".
std::string three_figures(double value) {
  char text[32];
  const int decimals = value >= 100 ? 0 : value >= 10 ? 1 : 2;
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

}  // namespace

std::string count_in_words(const Yarn& yarn) {
  const double tex = static_cast<double>(tex_of(yarn));
  if (!(tex > 0)) return tr("thickness set by the draft");
  const auto figure = [tex](CountUnit unit) { return with_decimal_point(three_figures(count_of(tex, unit))); };
  std::string counts = fill(tr("Ne {ne}, Nm {nm}, {denier} den"), arg("ne", figure(CountUnit::kNe)),
                            arg("nm", figure(CountUnit::kNm)), arg("denier", figure(CountUnit::kDenier)));
  if (!written_count(yarn).ends_with("tex"))  // the field has the unit of the trade
    counts = fill(tr("{tex} tex; {counts}"), arg("tex", figure(CountUnit::kTex)), arg("counts", counts));
  counts += "\n";
  if (!(yarn.tex > 0)) return counts + tr("computed from the thickness");
  const double fibre = packing_fraction(yarn);
  if (fibre > kMaxPacking) return counts + tr("too much fibre for this thickness");
  if (fibre <= 0) return counts + tr("as entered");
  return counts + fill(tr("{percent}% of the yarn is fibre"), arg("percent", std::lround(100 * fibre)));
}

std::string count_in_draft(const Design& design, int yarn) {
  constexpr double kSame_mm = 0.001;
  const auto thick = static_cast<double>(design.yarns[static_cast<size_t>(yarn)].diameter_mm);
  const auto words = [&](System system, const char* pattern) -> std::string {
    const MeanThread mean = mean_thread(design, system, yarn);
    if (mean.threads == 0 || std::abs(mean.diameter_mm - thick) < kSame_mm) return {};
    const auto figure = [](double value) { return with_decimal_point(three_figures(value)); };
    return fill(pattern, arg("thickness", figure(mean.diameter_mm)), arg("tex", figure(mean.tex)));
  };
  const std::string ends = words(System::kWarp, tr("Ends: {thickness} mm, {tex} tex")),
                    picks = words(System::kWeft, tr("Picks: {thickness} mm, {tex} tex"));
  return ends.empty() || picks.empty() ? ends + picks : ends + "\n" + picks;
}

bool draw_count(const PanelContext& c, Yarn& yarn) {
  row_label(c, tr("Count"),
            tr("Yarn count as it is sold: Ne 8/2, Nm 30/2, 16 lea, 150 den, 30 tex. It sets the thickness, which can "
               "be changed afterwards. If empty, the count is computed from the thickness"));
  ImGui::SetNextItemWidth(-FLT_MIN);
  std::string typed = written_count(yarn);
  const ImGuiID unread = ImGui::GetID("##count not understood");
  ImGuiStorage& kept = *ImGui::GetStateStorage();
  const bool entered = ImGui::InputText("##count", &typed, ImGuiInputTextFlags_EnterReturnsTrue);
  c.map.add_item("yarn.count");
  if (ImGui::IsItemActivated()) kept.SetBool(unread, false);
  const std::optional<Yarn> spun = entered ? with_count(yarn, typed) : yarn;
  if (!spun) kept.SetBool(unread, true);
  if (kept.GetBool(unread))
    draw_words(c, tr("Not understood. Examples: Ne 8/2, Nm 30/2, 16 lea, 150 den, 30 tex"), c.style.color.error,
               tr("A number with its unit, and the plies after a slash; 0.1 to 100,000 tex"));
  else
    draw_words(c, count_in_words(yarn), c.style.color.muted,
               tr("The same count in other units. Weight, stiffness and yarn requirements use the count, the picture "
                  "uses the thickness"));
  if (!entered || !spun) return false;
  yarn = *spun;
  return true;
}

}  // namespace weftlight::views
