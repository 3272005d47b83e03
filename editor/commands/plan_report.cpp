// The plan of the cloth as `analyse` gives it: in words, and as JSON.

#include <cstdio>

#include "analysis/plan_texts.h"
#include "base/json.h"
#include "base/text.h"
#include "commands/commands.h"
#include "commands/open_design.h"
#include "commands/plan_options.h"
#include "design/fibre.h"
#include "draft/drawdown.h"
#include "draft/hex_color.h"

namespace weftlight::commands {

using analysis::ClothMeasures, analysis::EdgeBinding, analysis::Selvedges, analysis::SleyedReed, analysis::ThreadOrder,
    analysis::ThreadRun, analysis::WarpingPlan, analysis::YarnNeed, analysis::YarnReport, analysis::YarnToBuy,
    analysis::area_weight_text, analysis::bought_text, analysis::bouts_text, analysis::cloth_measures,
    analysis::deviation_text, analysis::ends_text, analysis::last_end_of, analysis::nearest_reeds,
    analysis::raddle_text, analysis::reed_text, analysis::repeats_text, analysis::selvedges, analysis::selvedges_text,
    analysis::sett_text, analysis::sleying_words, analysis::thread_order, analysis::warp_length_text,
    analysis::warping_plan, analysis::weight_text, analysis::width_text, analysis::yarn_length_text,
    analysis::yarn_report;
using base::arg, base::fill, base::tr, base::tr_n;
using design::ClothPlan, design::sleying_text;
using draft::Rgb, draft::System, draft::drawdown;

namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kNearReeds = 6, kMaxRuns = 40;

Selvedges selvedges_of(const Design& design, const ClothMeasures& m) {
  return selvedges(drawdown(design.draft), last_end_of(design.draft, m.ends));
}

/// "#c0392b".
std::string hex_of(const Design& design, int color) {
  return fmt::format("#{:06x}", draft::packed_rgb(design.draft.palette[static_cast<size_t>(color)]));
}

std::string runs_text(const Design& design, const std::vector<ThreadRun>& runs) {
  std::string text;
  for (size_t i = 0; i < runs.size(); ++i) {
    if (i == kMaxRuns) return text.append(", ").append(tr("... all with --json"));
    text.append(i == 0 ? "" : ", ")
        .append(std::to_string(runs[i].threads))
        .append(" ")
        .append(hex_of(design, runs[i].color));
  }
  return text;
}

std::string order_text(const Design& design, const ThreadOrder& order) {
  std::string text = runs_text(design, order.repeat);
  if (order.times > 1)
    text = fill(tr_n("{runs}; repeat all {count} time", "{runs}; repeat all {count} times", order.times),
                arg("runs", text), arg("count", order.times));
  return order.rest.empty()
             ? text
             : fill(tr("{runs}; then {rest}"), arg("runs", text), arg("rest", runs_text(design, order.rest)));
}

void print_size(const ClothMeasures& m, const ClothPlan& plan, Units units) {
  print_row(tr("finished"), fill(tr("{width} wide, {length} long"), arg("width", width_text(m.width_mm, units)),
                                 arg("length", width_text(m.length_mm, units))));
  if (plan.pieces > 1) print_row(tr("pieces"), std::to_string(plan.pieces));
  print_row(tr("on the loom"), fill(tr("{width} in the reed, {length} woven under tension a piece"),
                                    arg("width", width_text(m.reed_width_mm, units)),
                                    arg("length", width_text(m.woven_length_mm, units))));
  const auto setts = [&](double ends, double picks) {
    return fill(tr("{ends}, {picks}"), arg("ends", sett_text(ends, System::kWarp, units)),
                arg("picks", sett_text(picks, System::kWeft, units)));
  };
  print_row(tr("cloth sett"), setts(m.cloth_ends_per_cm, m.cloth_picks_per_cm));
  print_row(tr("loom sett"), setts(m.loom_ends_per_cm, m.loom_picks_per_cm));  // the reeds follow
}

void print_reeds(const ClothMeasures& m, const ClothPlan& plan, Units units) {
  if (plan.reed.dents > 0)
    print_row(tr("reed"), fill(tr_n("{reed}, {sleying}; {count} dent", "{reed}, {sleying}; {count} dents", m.dents),
                               arg("reed", reed_text(plan.reed)), arg("sleying", sleying_words(plan.sleying)),
                               arg("count", m.dents)));
  for (const SleyedReed& r : nearest_reeds(m.wanted_ends_per_cm, units == Units::kImperial, kNearReeds))
    print_row(tr("  near"), fill(tr("{reed}, {sleying}: {sett}, {deviation}"), arg("reed", reed_text(r.reed)),
                                 arg("sleying", sleying_words(r.sleying)),
                                 arg("sett", sett_text(r.ends_per_cm, System::kWarp, units)),
                                 arg("deviation", deviation_text(r.deviation))));
}

void print_warping(const Design& design, const ClothMeasures& m, Units units) {
  const WarpingPlan w = warping_plan(design, m);
  print_row(tr("warp"), fill(tr("{ends}, {length} long"), arg("ends", ends_text(m)),
                             arg("length", warp_length_text(m.warp_length_mm, units))));
  if (const std::string repeats = repeats_text(w); !repeats.empty()) print_row(tr("threading"), repeats);
  print_row(tr("bouts"), bouts_text(w));
  print_row(tr("raddle"), raddle_text(w));
  print_row(tr("colours"), order_text(design, thread_order(design, System::kWarp, m.ends)));
  print_row(tr("selvedges"), selvedges_text(selvedges_of(design, m)));
  print_row(tr("picks"), std::to_string(m.picks));
}

void print_need(const Design& design, const YarnNeed& need, Units units) {
  const std::string line =
      fill(tr_n("{system} {yarn:<16} {colour} {threads:6} thread  {length:>10} {weight:>9}",
                "{system} {yarn:<16} {colour} {threads:6} threads {length:>10} {weight:>9}", need.threads),
           arg("system", need.system == System::kWarp ? tr("warp") : tr("weft")),
           arg("yarn", design.yarns[static_cast<size_t>(need.yarn)].name), arg("colour", hex_of(design, need.color)),
           arg("threads", need.threads), arg("length", yarn_length_text(need.length_m, units)),
           arg("weight", weight_text(need.weight_g, units)));
  std::printf("  %s\n", line.c_str());
}

void print_yarn(const Design& design, const ClothMeasures& m, Units units) {
  const YarnReport y = yarn_report(design, m);
  print_row(tr("yarn"),
            fill(tr("warp {warp}, weft {weft}, {weight}; {area} finished"),
                 arg("warp", yarn_length_text(y.warp_m, units)), arg("weft", yarn_length_text(y.weft_m, units)),
                 arg("weight", weight_text(y.weight_g, units)), arg("area", area_weight_text(y.g_per_m2, units))));
  for (const YarnNeed& need : y.needs) print_need(design, need, units);
  for (const YarnToBuy& one : y.buy) {
    const std::string what =
        fill(tr("{amount} of {yarn} {colour}"), arg("amount", bought_text(one, units)),
             arg("yarn", design.yarns[static_cast<size_t>(one.yarn)].name), arg("colour", hex_of(design, one.color)));
    print_row(tr("buy"), one.cost < 0 ? what : fill("{what}: {cost:.2f}", arg("what", what), arg("cost", one.cost)));
  }
  if (y.cost >= 0) print_row(tr("cost"), fill("{cost:.2f}", arg("cost", y.cost)));
}

Json needs_json(const Design& design, const YarnReport& yarn) {
  Json needs = Json::array();
  for (const YarnNeed& need : yarn.needs) {
    const Rgb& c = design.draft.palette[static_cast<size_t>(need.color)];
    needs.push_back({{"system", need.system == System::kWarp ? "warp" : "weft"},
                     {"yarn", design.yarns[static_cast<size_t>(need.yarn)].name},
                     {"color", {c.r, c.g, c.b}},
                     {"threads", need.threads},
                     {"length_m", need.length_m},
                     {"weight_g", need.weight_g},
                     {"tex", need.tex}});
  }
  return needs;
}

Json buy_json(const Design& design, const YarnReport& yarn) {
  Json buy = Json::array();
  for (const YarnToBuy& one : yarn.buy) {
    Json entry = {{"yarn", design.yarns[static_cast<size_t>(one.yarn)].name},
                  {"color", hex_of(design, one.color)},
                  {"length_m", one.length_m},
                  {"weight_g", one.weight_g}};
    if (one.cones > 0) entry["cones"] = one.cones;
    if (one.cost >= 0) entry["cost"] = one.cost;
    buy.push_back(std::move(entry));
  }
  return buy;
}

Json yarn_json(const Design& design, const ClothMeasures& m) {
  const YarnReport yarn = yarn_report(design, m);
  Json json = {{"ends", m.ends},
               {"picks", m.picks},
               {"ends_per_cm", m.draft_ends_per_cm},
               {"picks_per_cm", m.draft_picks_per_cm},
               {"loom_width_mm", m.reed_width_mm},
               {"warp_length_mm", m.warp_length_mm},
               {"warp_m", yarn.warp_m},
               {"weft_m", yarn.weft_m},
               {"weight_g", yarn.weight_g},
               {"g_per_m2", yarn.g_per_m2},
               {"needs", needs_json(design, yarn)},
               {"buy", buy_json(design, yarn)}};
  if (yarn.cost >= 0) json["cost"] = yarn.cost;
  return json;
}

Json reed_json(const design::Reed& reed, const std::vector<int>& sleying, double ends_per_cm) {
  return {{"dents", reed.dents},
          {"per", reed.per_inch ? "inch" : "10 cm"},
          {"sleying", sleying_text(sleying)},
          {"ends_per_cm", ends_per_cm}};
}

Json reeds_json(const ClothMeasures& m) {
  Json near = Json::array();
  for (const bool per_inch : {false, true})
    for (const SleyedReed& r : nearest_reeds(m.wanted_ends_per_cm, per_inch, kNearReeds)) {
      Json one = reed_json(r.reed, r.sleying, r.ends_per_cm);
      one["deviation"] = r.deviation;
      near.push_back(std::move(one));
    }
  return near;
}

Json runs_json(const Design& design, const std::vector<ThreadRun>& runs) {
  Json list = Json::array();
  for (const ThreadRun& run : runs)
    list.push_back({{"threads", run.threads},
                    {"color", hex_of(design, run.color)},
                    {"yarn", design.yarns[static_cast<size_t>(run.yarn)].name}});
  return list;
}

Json warping_json(const Design& design, const ClothMeasures& m) {
  const WarpingPlan w = warping_plan(design, m);
  const ThreadOrder order = thread_order(design, System::kWarp, m.ends);
  return {
      {"ends", w.ends},
      {"floating_selvedges", m.floating},
      {"bouts", w.bouts},
      {"ends_in_bout", w.ends_in_bout},
      {"ends_in_last_bout", w.ends_in_last},
      {"raddle_groups", w.raddle_groups},
      {"ends_in_group", sleying_text(w.raddle)},
      {"colours",
       {{"repeat", runs_json(design, order.repeat)}, {"times", order.times}, {"rest", runs_json(design, order.rest)}}}};
}

Json edge_json(const EdgeBinding& edge) {
  return {{"turns", edge.turns}, {"missed", edge.missed}, {"unbound_picks", edge.unbound_picks}};
}

Json selvedges_json(const Selvedges& s) {
  const auto start = [](const Selvedges::Start& one) {
    return Json{{"end_1", edge_json(one.first)}, {"last_end", edge_json(one.last)}};
  };
  return {{"floating_needed", s.floating_needed()},
          {"first_pick_to_last_end", start(s.starts[0])},
          {"first_pick_to_end_1", start(s.starts[1])}};
}

Json plan_json(const Design& design, const ClothMeasures& m) {
  const ClothPlan& plan = design.plan;
  Json json = {{"pieces", plan.pieces},
               {"width_mm", m.width_mm},
               {"length_mm", m.length_mm},
               {"reed_width_mm", m.reed_width_mm},
               {"woven_width_mm", m.woven_width_mm},
               {"woven_length_mm", m.woven_length_mm},
               {"warp_length_mm", m.warp_length_mm},
               {"loom", {{"ends_per_cm", m.loom_ends_per_cm}, {"picks_per_cm", m.loom_picks_per_cm}}},
               {"finished", {{"ends_per_cm", m.cloth_ends_per_cm}, {"picks_per_cm", m.cloth_picks_per_cm}}},
               {"wanted_ends_per_cm", m.wanted_ends_per_cm}};
  if (plan.reed.dents > 0) {
    json["reed"] = reed_json(plan.reed, plan.sleying, m.loom_ends_per_cm);
    json["reed"]["dents_used"] = m.dents;
  }
  json["near_reeds"] = reeds_json(m);
  json["warping"] = warping_json(design, m);
  json["selvedges"] = selvedges_json(selvedges_of(design, m));
  return json;
}

}  // namespace

void print_plan(const Design& design, Units units) {
  const ClothMeasures m = cloth_measures(design);
  if (m.ends == 0) return;
  print_size(m, design.plan, units);
  print_reeds(m, design.plan, units);
  print_warping(design, m, units);
  print_yarn(design, m, units);
}

void add_plan_json(const Design& design, nlohmann::ordered_json& json) {
  const ClothMeasures m = cloth_measures(design);
  json["yarn"] = yarn_json(design, m);
  json["plan"] = plan_json(design, m);
}

}  // namespace weftlight::commands
