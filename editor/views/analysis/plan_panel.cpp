#include "views/analysis/plan_panel.h"

#include <imgui.h>

#include <cmath>

#include "base/text.h"
#include "design/edits.h"
#include "ui/widgets.h"
#include "views/analysis/plan_rows.h"

namespace weftlight::views {

using analysis::ClothMeasures, analysis::cloth_measures, analysis::kInch_mm, analysis::last_end_of,
    analysis::nearest_reeds, analysis::sett_text, analysis::thread_order, analysis::warping_plan, analysis::width_text,
    analysis::yarn_report;
using base::arg, base::fill, base::mark, base::tr, base::tr_in;
using design::Design, design::with_plan, design::with_sett;
using draft::System;
using session::Edit;
using ui::row_label, ui::section, ui::segmented, ui::slider, ui::text_button;

namespace {

constexpr size_t kNearReeds = 6;

void compute(const PanelContext& c, Units units, PlanState& s) {
  if (s.revision == c.revision && s.units == units) return;
  s.revision = c.revision;
  s.units = units;
  s.measures = cloth_measures(c.design);
  s.warping = warping_plan(c.design, s.measures);
  s.warp_order = thread_order(c.design, System::kWarp, s.measures.ends);
  s.selvedges = analysis::selvedges(c.cells, last_end_of(c.design.draft, s.measures.ends));
  s.reeds = nearest_reeds(s.measures.wanted_ends_per_cm, units == Units::kImperial, kNearReeds);
  s.yarn = yarn_report(c.design, s.measures);
}

void draw_units(const PlanPanel& c) {
  constexpr const char* kUnits[] = {mark("Metric"), mark("Imperial")};
  row_label(c, tr("Units"), tr("Centimetres and grams, or inches, yards, ounces and pounds; everywhere"));
  int chosen = static_cast<int>(c.state.units);
  if (segmented(c, "plan.units", kUnits, chosen))
    c.wanted.change_settings([chosen](Settings& s) { s.imperial = chosen == 1; });
}

void draw_pieces(PlanPanel& c) {
  auto pieces = static_cast<float>(c.design.plan.pieces);
  if (slider(c,
             {"plan.pieces", tr("Pieces"), 1, 20, "%.0f", tr("Cloths of that length, one after the other on one warp"),
              false, 1, static_cast<float>(design::kMaxPieces)},
             pieces))
    change_plan(c, tr("Pieces"), [n = static_cast<int>(std::lround(pieces))](ClothPlan& p) { p.pieces = n; });
}

void draw_size(PlanPanel& c) {
  const char* tip = tr("Of the finished cloth; 0 takes the threads of the draft as they are");
  draw_length(c, "width", tr("Width"), tip, 2000, &ClothPlan::width_mm, tr("as draft"));
  draw_length(c, "length", tr("Length"), tip, 5000, &ClothPlan::length_mm, tr("as draft"));
  draw_pieces(c);
  draw_length(c, "fringe", tr("Fringe"), tr("Warp left unwoven for each piece, both ends together"), 500,
              &ClothPlan::fringe_mm);
  const ClothMeasures& m = c.state.measures;
  draw_fact(c, "plan.finished", tr("Finished"),
            fill(tr("{width} wide, {length} long"), arg("width", width_text(m.width_mm, c.state.units)),
                 arg("length", width_text(m.length_mm, c.state.units))),
            tr("In whole threads"));
}

/// Threads in a cm or inch on the loom.
void draw_sett(PlanPanel& c, const char* id, System system, float ClothPlan::*per_cm) {
  const bool inches = c.state.units == Units::kImperial, warp = system == System::kWarp;
  const char* unit = c.design.plan.*per_cm <= 0 ? tr("as draft") : inches ? tr("%.1f /in") : tr("%.1f /cm");
  const char* tip = warp ? tr("Desired sett on the loom; 0 gives the finished cloth the sett of the draft")
                         : tr("Picks woven under tension; 0 gives the finished cloth the sett of the draft");
  draw_number(c,
              {id, warp ? tr("Ends") : tr("Picks"), tip, unit, inches ? kInch_mm / 10 : 1.0, inches ? 100.0f : 40.0f,
               design::kMaxSettPerCm * (inches ? 2.54f : 1.0f), tr("Sett")},
              per_cm);
}

/// The cloth comes out at another sett than it is drawn with: offers to draw it so.
void draw_difference(PlanPanel& c) {
  const ClothMeasures& m = c.state.measures;
  const auto differs = [](double a, double b) { return std::abs(a - b) > 0.005 * b; };
  const double ends = m.cloth_ends_per_cm, picks = m.cloth_picks_per_cm;
  if (!differs(ends, m.draft_ends_per_cm) && !differs(picks, m.draft_picks_per_cm)) return;
  draw_fact(c, "plan.differs", tr("Draft"),
            fill(tr("Sett as drawn:\n{ends}\n{picks}"),
                 arg("ends", sett_text(m.draft_ends_per_cm, System::kWarp, c.state.units)),
                 arg("picks", sett_text(m.draft_picks_per_cm, System::kWeft, c.state.units))));
  row_label(c, "", "");
  if (text_button(c, "plan.draw", tr("Apply planned sett"), tr("Sets the draft to the sett of the finished cloth")))
    c.edit = Edit{tr("Apply planned sett"), [ends, picks](Design d) {
                    return with_sett(with_sett(std::move(d), System::kWarp, ends), System::kWeft, picks);
                  }};
}

void draw_on_loom(PlanPanel& c) {
  draw_percent(c, "warp_take_up", tr("Warp take-up"), tr("How much longer the warp is than the cloth woven from it"),
               &ClothPlan::warp_take_up);
  draw_percent(c, "weft_take_up", tr("Weft take-up"),
               tr("Draw-in: how much wider the warp stands in the reed than the cloth that is woven"),
               &ClothPlan::weft_take_up);
  draw_percent(c, "warp_shrinkage", tr("Warp shrinkage"), tr("Shrinkage of the length, off the loom and in washing"),
               &ClothPlan::warp_shrinkage);
  draw_percent(c, "weft_shrinkage", tr("Weft shrinkage"), tr("Shrinkage of the width, off the loom and in washing"),
               &ClothPlan::weft_shrinkage);
  draw_length(c, "waste", tr("Loom waste"), tr("Length of warp that cannot be woven"), 2000, &ClothPlan::loom_waste_mm);
  draw_sett(c, "picks", System::kWeft, &ClothPlan::picks_per_cm);
  const ClothMeasures& m = c.state.measures;
  const Units units = c.state.units;
  draw_fact(c, "plan.weave", tr_in("at the loom", "Weave"),
            fill(tr("{length} under tension\n{picks}"), arg("length", width_text(m.woven_length_mm, units)),
                 arg("picks", sett_text(m.loom_picks_per_cm, System::kWeft, units))),
            tr("Length of a piece, measured on the loom before the tension is let off"));
  draw_fact(c, "plan.sett", tr("Finished sett"),
            sett_text(m.cloth_ends_per_cm, System::kWarp, units) + "\n" +
                sett_text(m.cloth_picks_per_cm, System::kWeft, units));
  draw_difference(c);
}

}  // namespace

void change_plan(PlanPanel& c, const char* property, const std::function<void(ClothPlan&)>& change) {
  c.edit = Edit{property, [change](Design d) {
                  ClothPlan plan = d.plan;
                  change(plan);
                  return with_plan(std::move(d), std::move(plan));
                }};
  ClothPlan plan = c.design.plan;
  change(plan);
  c.wanted.change_settings([plan = std::move(plan)](Settings& s) { remember_plan(s, plan); });
}

void draw_number(PlanPanel& c, const PlanRow& row, float ClothPlan::*number) {
  const std::string id = std::string("plan.").append(row.id);
  auto shown = static_cast<float>(static_cast<double>(c.design.plan.*number) * row.scale);
  if (!slider(c, {id.c_str(), row.label, 0, row.to, row.format, row.tip, false, 0, row.limit}, shown)) return;
  const auto kept = static_cast<float>(static_cast<double>(shown) / row.scale);
  change_plan(c, row.edit ? row.edit : row.label, [number, kept](ClothPlan& p) { p.*number = kept; });
}

void draw_length(PlanPanel& c, const char* id, const char* label, const char* tip, float to_mm,
                 float ClothPlan::*length, const char* zero) {
  const bool inches = c.state.units == Units::kImperial;
  const double scale = inches ? 1 / kInch_mm : 0.1;
  const auto shown = [scale](float mm) { return static_cast<float>(std::round(static_cast<double>(mm) * scale)); };
  const bool none = zero != nullptr && c.design.plan.*length <= 0;
  draw_number(c,
              {id, label, tip,
               none     ? zero
               : inches ? tr("%.1f in")
                        : tr("%.1f cm"),
               scale, shown(to_mm), shown(design::kMaxClothMm)},
              length);
}

void draw_percent(PlanPanel& c, const char* id, const char* label, const char* tip, float ClothPlan::*part) {
  draw_number(c, {id, label, tip, "%.1f%%", 100, 40, 90}, part);
}

void draw_fact(const PanelContext& c, const char* id, const char* label, const std::string& text, const char* tip) {
  row_label(c, label, tip);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  c.map.add_item(id);
}

MaybeEdit draw_plan(PanelContext& panel, PlanState& state) {
  compute(panel, units_of(panel.settings), state);
  PlanPanel c{panel, state};
  draw_units(c);
  if (section(c, "section.size", tr("Size"))) draw_size(c);
  if (section(c, "section.on_loom", tr("On the loom"))) draw_on_loom(c);
  if (section(c, "section.reed", tr("Reed"))) {
    draw_sett(c, "ends", System::kWarp, &ClothPlan::ends_per_cm);
    draw_reed(c);
  }
  if (section(c, "section.warping", tr("Warping"))) draw_warping(c);
  if (section(c, "section.buy", tr("Yarn to buy"))) draw_purchases(c);
  return c.edit;
}

}  // namespace weftlight::views
