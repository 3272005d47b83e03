// The lists of a planned cloth: its plan, warping, sleyings, heddles and yarn. All are of the same cloth.

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "analysis/plan_texts.h"
#include "base/text.h"
#include "draft/drawdown.h"
#include "draft/hex_color.h"
#include "print/lines.h"

namespace weftlight::print {

using analysis::Heddles, analysis::ThreadOrder, analysis::ThreadRun, analysis::WarpingPlan, analysis::YarnNeed,
    analysis::YarnReport, analysis::YarnToBuy, analysis::area_weight_text, analysis::bought_text, analysis::bouts_text,
    analysis::ends_text, analysis::heddles_for, analysis::kInch_mm, analysis::last_end_of, analysis::nearest_reeds,
    analysis::raddle_text, analysis::reed_text, analysis::repeats_text, analysis::selvedges, analysis::selvedges_text,
    analysis::sett_in_reed, analysis::sett_text, analysis::sleying_patterns, analysis::sleying_words,
    analysis::thread_order, analysis::warp_length_text, analysis::warping_plan, analysis::weight_text,
    analysis::width_text, analysis::yarn_length_text, analysis::yarn_report;
using base::arg, base::fill, base::tr, base::tr_in, base::tr_n;
using design::ClothPlan, design::Reed, design::sleying_text;
using draft::System, draft::Threads, draft::drawdown, draft::hex_of;

namespace {

constexpr size_t kRunsInLine = 6, kMaxRuns = 4000;

void add(std::vector<ListLine>& out, std::string head, std::string text, int color = -1) {
  if (!text.empty()) out.push_back({std::move(head), {{std::move(text), color}}});
}

/// Sentences are longer than a column: a line for every `width` characters, broken at blanks.
void add_wrapped(std::vector<ListLine>& out, std::string head, std::string_view text, int color = -1) {
  constexpr size_t kWidth = 40, kChipWidth = 4;
  while (text.size() > kWidth) {
    size_t at = text.rfind(' ', color < 0 ? kWidth : kWidth - kChipWidth);
    if (at == std::string_view::npos) at = text.find(' ');
    if (at == std::string_view::npos) break;
    add(out, std::exchange(head, {}), std::string(text.substr(0, at)), std::exchange(color, -1));
    text.remove_prefix(at + 1);
  }
  add(out, std::move(head), std::string(text), color);
}

/// The yarns of each colour of the threads.
std::map<int, std::set<int>> yarns_by_color(const Draft& draft) {
  std::map<int, std::set<int>> yarns;
  for (const Threads* threads : {&draft.warp, &draft.weft})
    for (size_t i = 0; i < threads->color.size(); ++i) yarns[threads->color[i]].insert(threads->yarn[i]);
  return yarns;
}

void list_sizes(std::vector<ListLine>& out, const PlannedCloth& c) {
  const ClothMeasures& m = c.measures;
  const ClothPlan& plan = c.design.plan;
  const auto text = [&](double mm) { return width_text(mm, c.units); };
  add(out, tr("Finished"),
      fill(tr("{width} wide, {length} long"), arg("width", text(m.width_mm)), arg("length", text(m.length_mm))));
  add(out, tr_in("at the loom", "Weave"), fill(tr("{length} under tension"), arg("length", text(m.woven_length_mm))));
  if (plan.pieces > 1) add(out, tr("Pieces"), std::to_string(plan.pieces));
  add(out, tr("In the reed"), text(m.reed_width_mm));
  add(out, tr("Warp"), ends_text(m));
  add(out, "", fill(tr("{length} long"), arg("length", warp_length_text(m.warp_length_mm, c.units))));
  add(out, tr("Picks"), std::to_string(m.picks));
}

void list_setts(std::vector<ListLine>& out, const PlannedCloth& c) {
  const ClothMeasures& m = c.measures;
  const ClothPlan& plan = c.design.plan;
  add(out, tr("On the loom"), sett_text(m.loom_ends_per_cm, System::kWarp, c.units));
  add(out, "", sett_text(m.loom_picks_per_cm, System::kWeft, c.units));
  add(out, tr("Finished"), sett_text(m.cloth_ends_per_cm, System::kWarp, c.units));
  add(out, "", sett_text(m.cloth_picks_per_cm, System::kWeft, c.units));
  if (plan.reed.dents <= 0) return;
  add(out, tr("Reed"), reed_text(plan.reed));
  add(out, "", sleying_words(plan.sleying));
  add(out, "", fill(tr_n("{count} dent", "{count} dents", m.dents), arg("count", m.dents)));
}

void add_runs(std::vector<ListLine>& out, const std::vector<ThreadRun>& runs, double room_mm) {
  ListLine line;
  double taken = 0;
  for (size_t i = 0; i < runs.size(); ++i) {
    if (i == kMaxRuns) return out.push_back({"", {{tr("and so on"), -1}}});
    Word word{std::to_string(runs[i].threads), runs[i].color};
    const double room = room_for(word);
    if (line.words.size() == kRunsInLine || (taken > 0 && taken + room > room_mm))
      out.push_back(std::exchange(line, {})), taken = 0;
    line.words.push_back(std::move(word));
    taken += room;
  }
  if (!line.words.empty()) out.push_back(std::move(line));
}

std::string number_text(double value) { return fill("{value:.1f}", arg("value", value)); }
std::string cost_text(double value) { return fill("{value:.2f}", arg("value", value)); }

}  // namespace

ListLine line_of_times(int64_t times) {
  return {"", {{fill(tr_n("repeat all {count} time", "repeat all {count} times", times), arg("count", times)), -1}}};
}

void list_palette(std::vector<ListLine>& out, const PlannedCloth& c) {
  out.push_back({tr("Colours"), {}});
  for (const auto& [color, yarns] : yarns_by_color(c.design.draft)) {
    std::string names;
    for (const int yarn : yarns)
      names.append(names.empty() ? "" : ", ").append(c.design.yarns[static_cast<size_t>(yarn)].name);
    if (names.empty()) names = "\xE2\x80\x93";
    add_wrapped(out, hex_of(c.design.draft.palette[static_cast<size_t>(color)]), names, color);
  }
}

void list_plan(std::vector<ListLine>& out, const PlannedCloth& c) {
  out.push_back({tr("Plan of the cloth"), {}});
  list_sizes(out, c);
  out.push_back({tr("Sett"), {}});
  list_setts(out, c);
  out.push_back({tr("Warping"), {}});
  const WarpingPlan warping = warping_plan(c.design, c.measures);
  add_wrapped(out, tr("Threading"), repeats_text(warping));
  add_wrapped(out, tr("Bouts"), bouts_text(warping));
  add_wrapped(out, tr("Raddle"), raddle_text(warping));
  add_wrapped(out, tr("Selvedges"),
              selvedges_text(selvedges(drawdown(c.design.draft), last_end_of(c.design.draft, c.measures.ends))));
}

void list_warp_order(std::vector<ListLine>& out, const PlannedCloth& c) {
  const ThreadOrder order = thread_order(c.design, System::kWarp, c.measures.ends);
  out.push_back({tr("Warp colour order"), {}});
  add_runs(out, order.repeat, c.room_mm);
  if (order.times > 1) out.push_back(line_of_times(order.times));
  if (order.rest.empty()) return;
  add(out, "", tr("then"));
  add_runs(out, order.rest, c.room_mm);
}

void list_sleyings(std::vector<ListLine>& out, const PlannedCloth& c) {
  constexpr double kFrom = 0.85, kTo = 1.18, kPitch_mm = 11;
  const double wanted = c.measures.wanted_ends_per_cm;
  const bool inch = c.units == Units::kImperial;
  const auto most = static_cast<size_t>(std::clamp(c.room_mm / kPitch_mm, 1.0, 6.0));
  const auto near = nearest_reeds(wanted, inch, most);
  if (near.empty()) return;
  std::vector<Reed> reeds;
  for (const auto& one : near) reeds.push_back(one.reed);
  std::ranges::sort(reeds, {}, &Reed::dents);
  out.push_back({inch ? tr("Sleying: ends per inch") : tr("Sleying: ends per cm"), {}});
  ListLine head{tr("Reed"), {}, kPitch_mm, true};
  for (const Reed& reed : reeds)
    head.words.push_back({inch ? fill("{dents:.4g}", arg("dents", reed.dents)) : reed_text(reed), -1});
  out.push_back(std::move(head));
  for (const std::vector<int>& sleying : sleying_patterns()) {
    ListLine line{sleying_text(sleying), {}, kPitch_mm};
    bool any = false;
    for (const Reed& reed : reeds) {
      const double sett = sett_in_reed(reed, sleying);
      const bool useful = sett > kFrom * wanted && sett < kTo * wanted;
      any = any || useful;
      line.words.push_back({useful ? number_text(inch ? sett * kInch_mm / 10 : sett) : "\xE2\x80\x93", -1});
    }
    if (any) out.push_back(std::move(line));
  }
}

void list_heddles(std::vector<ListLine>& out, const PlannedCloth& c) {
  const int64_t ends = c.measures.ends > 0 ? c.measures.ends : c.design.draft.ends();
  out.push_back({fill(tr_n("Heddles for {count} end", "Heddles for {count} ends", ends), arg("count", ends)), {}});
  const Heddles heddles = heddles_for(c.design.draft, ends);
  int64_t sum = 0;
  for (size_t s = 0; s < heddles.on_shaft.size(); ++s) {
    add(out, fill(tr("Shaft {number}"), arg("number", s + 1)), std::to_string(heddles.on_shaft[s]));
    sum += heddles.on_shaft[s];
  }
  add(out, tr("Total"), std::to_string(sum));
  if (heddles.unthreaded_ends > 0) add(out, tr("On no shaft"), std::to_string(heddles.unthreaded_ends));
}

void list_yarn(std::vector<ListLine>& out, const PlannedCloth& c) {
  const YarnReport r = yarn_report(c.design, c.measures);
  const auto name = [&](int yarn) { return c.design.yarns[static_cast<size_t>(yarn)].name; };
  out.push_back({tr("Yarn"), {}});
  for (const YarnNeed& need : r.needs)
    out.push_back({need.system == System::kWarp ? tr("Warp") : tr("Weft"),
                   {{yarn_length_text(need.length_m, c.units), need.color},
                    {weight_text(need.weight_g, c.units), -1},
                    {name(need.yarn), -1}}});
  out.push_back({tr("Yarn to buy"), {}});
  for (const YarnToBuy& one : r.buy) {
    const std::string hex = hex_of(c.design.draft.palette[static_cast<size_t>(one.color)]);
    ListLine line{hex, {{bought_text(one, c.units), one.color}, {name(one.yarn), -1}}};
    if (one.cost >= 0) line.words.push_back({cost_text(one.cost), -1});
    out.push_back(std::move(line));
  }
  add(out, tr("Weight"), weight_text(r.weight_g, c.units));
  add(out, "", fill(tr("{weight} finished"), arg("weight", area_weight_text(r.g_per_m2, c.units))));
  if (r.cost >= 0) add(out, tr("Cost"), cost_text(r.cost));
}

}  // namespace weftlight::print
