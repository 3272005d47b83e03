// The group "Reed" of the plan's panel, and the group "Warping".

#include <imgui.h>
#include <imgui_stdlib.h>

#include <array>
#include <cmath>

#include "base/text.h"
#include "ui/widgets.h"
#include "views/analysis/plan_rows.h"

namespace weftlight::views {

using analysis::ClothMeasures, analysis::SleyedReed, analysis::ThreadRun, analysis::bouts_text,
    analysis::deviation_text, analysis::ends_text, analysis::kInch_mm, analysis::raddle_text, analysis::reed_text,
    analysis::repeats_text, analysis::selvedges_text, analysis::sett_text, analysis::sleying_words,
    analysis::warp_length_text, analysis::width_text;
using base::arg, base::fill, base::mark, base::tr, base::tr_in, base::tr_n;
using design::sleying_from_text, design::sleying_text;
using draft::System;
using ui::draw_swatch, ui::list_row, ui::muted_text, ui::row_label, ui::segmented, ui::slider, ui::tooltip;

namespace {

void draw_dents(PlanPanel& c) {
  const design::Reed& reed = c.design.plan.reed;
  float dents = reed.dents;
  // The first reed is one of the weaver's own units.
  const bool per_inch = dents > 0 ? reed.per_inch : c.state.units == Units::kImperial;
  const char* format = dents > 0 ? (per_inch ? tr("%.4g /in") : tr("%.4g /10 cm")) : tr("none");
  if (slider(c,
             {"plan.reed", tr("Reed"), 0, per_inch ? 30.0f : 120.0f, format,
              tr("Dents of your reed; 0 if none is chosen yet. The list below has the reeds that suit"), false, 0,
              design::kMaxDents},
             dents))
    change_plan(c, tr("Reed"), [r = design::Reed{std::round(2 * dents) / 2, per_inch}](ClothPlan& p) { p.reed = r; });
  if (reed.dents <= 0) return;
  constexpr const char* kPer[] = {mark("per 10 cm"), mark("per inch")};
  row_label(c, tr("Dents"), tr("The length in which the dents are counted"));
  int per = reed.per_inch ? 1 : 0;
  if (segmented(c, "plan.reed_per", kPer, per))
    change_plan(c, tr("Reed"), [per](ClothPlan& p) { p.reed.per_inch = per == 1; });
}

void draw_sleying(PlanPanel& c) {
  row_label(c, tr("Sleying"), tr("Ends in each dent, repeated over the reed: 2, or 1-1-2; 0 leaves a dent empty"));
  ImGui::SetNextItemWidth(-FLT_MIN);
  std::string typed = sleying_text(c.design.plan.sleying);
  if (ImGui::InputText("##sleying", &typed, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll))
    if (std::vector<int> sleying = sleying_from_text(typed); !sleying.empty())
      change_plan(c, tr("Sleying"), [sleying = std::move(sleying)](ClothPlan& p) { p.sleying = sleying; });
  c.map.add_item("plan.sleying");
}

/// What the chosen reed makes of the sett and the width.
void draw_effect(PlanPanel& c) {
  const ClothMeasures& m = c.state.measures;
  const Units units = c.state.units;
  draw_fact(c, "plan.in_reed", tr("In the reed"),
            width_text(m.reed_width_mm, units) + "\n" + sett_text(m.loom_ends_per_cm, System::kWarp, units),
            tr("Width of the warp in the reed, without floating selvedges"));
  if (c.design.plan.reed.dents <= 0) return;
  const double off = m.loom_ends_per_cm / m.wanted_ends_per_cm - 1;
  const double same_ends_mm = m.reed_width_mm * m.loom_ends_per_cm / m.wanted_ends_per_cm;
  draw_fact(c, "plan.dents", "",
            fill(tr_n("{count} dent, {sleying}", "{count} dents, {sleying}", m.dents), arg("count", m.dents),
                 arg("sleying", sleying_words(c.design.plan.sleying))));
  if (std::abs(off) < 0.0005) return;
  draw_fact(c, "plan.off", "",
            fill(tr("{deviation} from the desired sett, which would make the warp {width} wide"),
                 arg("deviation", deviation_text(off)), arg("width", width_text(same_ends_mm, units))));
}

/// "22.5", in the units shown.
std::string sett_number(double per_cm, Units units) {
  return fill("{sett:.1f}", arg("sett", units == Units::kImperial ? per_cm * kInch_mm / 10 : per_cm));
}

/// Texts in the columns of the list of reeds.
void draw_columns(const PlanPanel& c, ImVec2 at, float room, const std::array<std::string, 4>& texts, ImU32 color) {
  constexpr float kLefts[] = {0.01f, 0.23f, 0.46f, 0.82f};
  for (size_t i = 0; i < texts.size(); ++i)
    ImGui::GetWindowDrawList()->AddText({at.x + kLefts[i] * room, at.y}, i == 3 ? c.style.color.muted : color,
                                        texts[i].c_str());
}

/// A row for each near reed; a click chooses it.
void draw_near_reeds(PlanPanel& c) {
  const ClothPlan& plan = c.design.plan;
  const bool inches = c.state.units == Units::kImperial;
  const float room = ImGui::GetContentRegionAvail().x;
  draw_columns(
      c, ImGui::GetCursorScreenPos(), room,
      {tr("Reed"), tr("Sleying"), inches ? tr("Ends per inch") : tr("Ends per cm"), tr_in("by how much", "Off")},
      c.style.color.muted);
  ImGui::Dummy({room, ImGui::GetTextLineHeight()});
  int number = 0;
  for (const SleyedReed& r : c.state.reeds) {
    const std::string id = "plan.reed:" + std::to_string(++number);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (list_row(c, id.c_str(), "##row", plan.reed == r.reed && plan.sleying == r.sleying))
      change_plan(c, tr("Reed"), [r](ClothPlan& p) { p.reed = r.reed, p.sleying = r.sleying; });
    tooltip(c, fill(tr("{reed}, {sleying}"), arg("reed", reed_text(r.reed)), arg("sleying", sleying_words(r.sleying)))
                   .c_str());
    const std::string dents = fill("{dents:.4g}", arg("dents", r.reed.dents));
    draw_columns(c, at, room,
                 {r.reed.per_inch ? fill(tr("{dents} /in"), arg("dents", dents)) : reed_text(r.reed),
                  sleying_text(r.sleying), sett_number(r.ends_per_cm, c.state.units), deviation_text(r.deviation)},
                 c.style.color.text);
  }
}

void draw_selvedges(PlanPanel& c) {
  row_label(c, tr("Selvedges"), tr("An end beside each edge, through the reed but through no heddle"));
  bool floating = c.design.plan.floating_selvedges;
  if (ImGui::Checkbox(tr("Floating"), &floating))
    change_plan(c, tr("Selvedges"), [floating](ClothPlan& p) { p.floating_selvedges = floating; });
  c.map.add_item("plan.floating");
  draw_fact(c, "plan.selvedges", "", selvedges_text(c.state.selvedges),
            tr("With one shuttle: whether the weft catches each edge end at every turn"));
}

/// Chips with the number of ends, as many in a line as fit.
void draw_runs(const PlanPanel& c, const std::vector<ThreadRun>& runs, const char* after) {
  constexpr size_t kMax = 60;
  const float side = ImGui::GetTextLineHeight(), gap = c.style.px(5), right = ImGui::GetContentRegionMax().x;
  for (size_t i = 0; i < std::min(runs.size(), kMax); ++i) {
    const std::string count = std::to_string(runs[i].threads);
    if (i > 0 &&
        ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + side + 4 * gap + ImGui::CalcTextSize(count.c_str()).x <
            right)
      ImGui::SameLine(0, 2 * gap);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_swatch(c, {at.x, at.y + 1}, {at.x + side - 2, at.y + side - 1},
                to_u32(c.design.draft.palette[static_cast<size_t>(runs[i].color)]));
    ImGui::GetWindowDrawList()->AddText({at.x + side + gap, at.y}, c.style.color.text, count.c_str());
    ImGui::Dummy({side + gap + ImGui::CalcTextSize(count.c_str()).x, side});
  }
  if (runs.size() > kMax) muted_text(c, tr("more; the full list is printed"));
  else if (*after != 0) muted_text(c, after);
}

void draw_warp_order(PlanPanel& c) {
  const analysis::ThreadOrder& order = c.state.warp_order;
  row_label(c, tr("Colours"), tr("Ends of each colour, in the order of winding from end 1"));
  ImGui::BeginGroup();
  const std::string times =
      order.times > 1
          ? fill(tr_n("repeat all {count} time", "repeat all {count} times", order.times), arg("count", order.times))
          : std::string();
  draw_runs(c, order.repeat, times.c_str());
  if (!order.rest.empty()) {
    muted_text(c, tr("then"));
    draw_runs(c, order.rest, "");
  }
  ImGui::EndGroup();
  c.map.add_item("plan.colours");
}

}  // namespace

void draw_reed(PlanPanel& c) {
  draw_dents(c);
  if (c.design.plan.reed.dents > 0) draw_sleying(c);
  draw_effect(c);
  draw_near_reeds(c);
  draw_selvedges(c);
}

void draw_warping(PlanPanel& c) {
  const analysis::WarpingPlan& w = c.state.warping;
  const ClothMeasures& m = c.state.measures;
  draw_fact(c, "plan.warp", tr("Warp"),
            fill(tr("{ends}, {length} long"), arg("ends", ends_text(m)),
                 arg("length", warp_length_text(m.warp_length_mm, c.state.units))),
            tr("With take-up, shrinkage, fringe and loom waste"));
  if (const std::string repeats = repeats_text(w); !repeats.empty())
    draw_fact(c, "plan.repeats", tr("Threading"), repeats);
  draw_length(c, "bout", tr("Bout"), tr("Width of the part of the warp that is wound at a time"), 500,
              &ClothPlan::bout_mm);
  draw_fact(c, "plan.bouts", "", bouts_text(w));
  draw_length(c, "raddle", tr("Raddle group"), tr("Spacing of the raddle pegs"), 50, &ClothPlan::raddle_mm);
  draw_fact(c, "plan.groups", "", raddle_text(w));
  draw_warp_order(c);
  draw_fact(c, "plan.weft", tr("Weft"), fill(tr_n("{count} pick", "{count} picks", m.picks), arg("count", m.picks)));
}

}  // namespace weftlight::views
