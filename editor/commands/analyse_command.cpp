// `analyse`: a draft as a weave and on a loom. `diff`: the differences between two drafts.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "analysis/difference.h"
#include "analysis/floats.h"
#include "analysis/threads.h"
#include "analysis/units.h"
#include "analysis/warping.h"
#include "analysis/weave_layers.h"
#include "base/json.h"
#include "base/text.h"
#include "commands/commands.h"
#include "commands/open_design.h"
#include "design/fibre.h"
#include "design/repeat.h"
#include "draft/factor.h"

namespace weftlight::commands {

using analysis::ClothMeasures, analysis::Comparison, analysis::Difference, analysis::Float, analysis::Interlacing,
    analysis::LongFloats, analysis::LongestFloats, analysis::LoomUse, analysis::MeanThread, analysis::WeaveLayer,
    analysis::Heddles, analysis::cloth_measures, analysis::heddles_for, analysis::kInch_mm, analysis::sett_text,
    analysis::compare, analysis::interlacing, analysis::long_floats, analysis::longest_floats, analysis::loom_use,
    analysis::mean_thread, analysis::thread_list, analysis::weave_layers, analysis::wraps_per_cm;
using base::arg, base::fill, base::tr, base::tr_n;
using design::Design, design::Repeat, design::Yarn, design::design_repeat, design::structure_repeat,
    design::spun_diameter_mm, design::tex_of, design::warp_up_fraction;
using draft::BitMatrix, draft::Face, draft::LoomSize, draft::System, draft::drawdown, draft::fewest_for;

namespace {

using Json = nlohmann::ordered_json;

struct DraftAnalysis {
  Repeat structure, design;
  LongestFloats longest;
  LongFloats floats;
  std::vector<WeaveLayer> layers;
  LoomUse loom;
  Heddles heddles;  // of the planned cloth
  LoomSize fewest;
  Interlacing interlacings;
  double warp_up = 0;    // fraction of the crossings
  double firm_sett = 0;  // as a fraction of the wraps
};

DraftAnalysis analysis_of(const Design& design, const AnalyseOptions& options) {
  const BitMatrix cells = drawdown(design.draft);
  const std::vector<WeaveLayer> layers = weave_layers(cells);
  return {structure_repeat(cells),
          design_repeat(design, cells),
          longest_floats(cells),
          long_floats(cells, options.float_limit),
          layers,
          loom_use(design.draft),
          heddles_for(design.draft, cloth_measures(design).ends),
          fewest_for(cells),
          interlacing(cells),
          warp_up_fraction(cells),
          analysis::firm_sett_per_cm(cells, layers, 1)};
}

/// For JSON.
const char* name_of(System system) { return system == System::kWarp ? "warp" : "weft"; }
const char* name_of(Face face) { return face == Face::kFront ? "front" : "back"; }

std::vector<int> from_one(std::vector<int> threads) {
  for (int& thread : threads) ++thread;
  return threads;
}

Json floats_json(const DraftAnalysis& f, int limit) {
  Json listed = Json::array();
  for (const Float& x : f.floats.listed)
    listed.push_back({{"system", name_of(x.system)},
                      {"face", name_of(x.face)},
                      {"thread", x.thread + 1},
                      {"first", x.first + 1},
                      {"length", x.length}});
  return {{"limit", limit},
          {"longest",
           {{"warp_front", f.longest.warp_front},
            {"warp_back", f.longest.warp_back},
            {"weft_front", f.longest.weft_front},
            {"weft_back", f.longest.weft_back}}},
          {"count", f.floats.count},
          {"listed", listed}};
}

Json layers_json(const DraftAnalysis& f) {
  Json list = Json::array();
  for (const WeaveLayer& layer : f.layers)
    list.push_back({{"loose", layer.loose()}, {"ends", from_one(layer.ends)}, {"picks", from_one(layer.picks)}});
  return list;
}

std::string as_json(const Design& design, const DraftAnalysis& f, const AnalyseOptions& options) {
  Json json = {{"repeat",
                {{"ends", f.structure.ends},
                 {"picks", f.structure.picks},
                 {"with_colors", {{"ends", f.design.ends}, {"picks", f.design.picks}}}}},
               {"floats", floats_json(f, options.float_limit)},
               {"layers", layers_json(f)},
               {"hangs_together", f.layers.size() <= 1},
               {"heddles", f.heddles.on_shaft},
               {"lifts", f.loom.lifts},
               {"treads", f.loom.treadle_uses},
               {"unthreaded_ends", f.heddles.unthreaded_ends},
               {"empty_picks", f.loom.empty_picks},
               {"fewest", {{"shafts", f.fewest.shafts}, {"treadles", f.fewest.treadles}}},
               {"balance",
                {{"warp_on_top", f.warp_up},
                 {"warp_interlacing", f.interlacings.warp},
                 {"weft_interlacing", f.interlacings.weft}}}};
  add_plan_json(design, json);
  // Names come from files and may be cut anywhere.
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string layer_text(const WeaveLayer& layer) {
  const std::string ends = thread_list(layer.ends), picks = thread_list(layer.picks);
  if (!layer.loose()) return fill(tr("layer: ends {ends}; picks {picks}"), arg("ends", ends), arg("picks", picks));
  return layer.ends.empty() ? fill(tr("loose pick: {picks}"), arg("picks", picks))
                            : fill(tr("loose end: {ends}"), arg("ends", ends));
}

void print_layers(const DraftAnalysis& f) {
  if (f.layers.size() <= 1) return print_row(tr("layers"), tr("one connected cloth"));
  const bool loose = std::any_of(f.layers.begin(), f.layers.end(), [](const WeaveLayer& l) { return l.loose(); });
  print_row(tr("layers"), fill(loose ? tr("{count} separate layers or loose threads, front to back")
                                     : tr("{count} separate layers, front to back"),
                               arg("count", f.layers.size())));
  for (const WeaveLayer& layer : f.layers) std::printf("  %s\n", layer_text(layer).c_str());
}

std::string float_text(const Float& x) {
  const bool warp = x.system == System::kWarp, front = x.face == Face::kFront;
  const char* form = warp    ? front ? tr("end {thread}, front, from pick {first}: {length}")
                                     : tr("end {thread}, back, from pick {first}: {length}")
                        : front ? tr("pick {thread}, front, from end {first}: {length}")
                             : tr("pick {thread}, back, from end {first}: {length}");
  return fill(form, arg("thread", x.thread + 1), arg("first", x.first + 1), arg("length", x.length));
}

void print_floats(const DraftAnalysis& f, int limit) {
  constexpr size_t kMaxListed = 20;
  print_row(tr("longest float"), longest_float_text(f.longest));
  print_row(fill(tr("floats over {limit}"), arg("limit", limit)), std::to_string(f.floats.count));
  for (size_t i = 0; i < f.floats.listed.size() && i < kMaxListed; ++i)
    std::printf("  %s\n", float_text(f.floats.listed[i]).c_str());
  if (f.floats.listed.size() > kMaxListed) std::printf("  %s\n", tr("... all with --json"));
}

void print_loom(const DraftAnalysis& f) {
  std::string heddles;
  for (size_t s = 0; s < f.heddles.on_shaft.size(); ++s)
    heddles += (s > 0 ? ", " : "") + std::to_string(s + 1) + ": " + std::to_string(f.heddles.on_shaft[s]);
  print_row(tr("heddles"), heddles);
  const int shafts = f.fewest.shafts, treadles = f.fewest.treadles;
  print_row(tr("fewest"),
            fill(tr("{shafts}, {treadles}"),
                 arg("shafts", fill(tr_n("{count} shaft", "{count} shafts", shafts), arg("count", shafts))),
                 arg("treadles", fill(tr_n("{count} treadle", "{count} treadles", treadles), arg("count", treadles)))));
  const auto ends = [](int64_t n) { return fill(tr_n("{count} end", "{count} ends", n), arg("count", n)); };
  const auto picks = [](int n) { return fill(tr_n("{count} pick", "{count} picks", n), arg("count", n)); };
  if (f.heddles.unthreaded_ends > 0) print_row(tr("on no shaft"), ends(f.heddles.unthreaded_ends));
  if (f.loom.empty_picks > 0) print_row(tr("nothing lifted"), picks(f.loom.empty_picks));
  print_row(tr("balance"),
            fill(tr("warp on top {percent:.0f}%; interlacing warp {warp:.2f}, weft {weft:.2f}"),
                 arg("percent", f.warp_up * 100), arg("warp", f.interlacings.warp), arg("weft", f.interlacings.weft)));
}

/// The sett on the loom that threads of one size alone would have.
void print_wraps(const std::string& yarn, double tex, double spun_mm, double firm_sett, Units units) {
  const bool imperial = units == Units::kImperial;
  const double wraps = wraps_per_cm(static_cast<float>(spun_mm));
  print_row(tr("firm sett"),
            fill(imperial ? tr("{yarn}: {tex:.1f} tex, {wraps:.1f} wraps per inch, {sett} on the loom")
                          : tr("{yarn}: {tex:.1f} tex, {wraps:.1f} wraps per cm, {sett} on the loom"),
                 arg("yarn", yarn), arg("tex", tex), arg("wraps", imperial ? wraps * kInch_mm / 10 : wraps),
                 arg("sett", sett_text(wraps * firm_sett, System::kWarp, units))));
}

/// Of a yarn as the draft's threads have it: warp and weft apart where it is thicker in one of them.
void print_wraps_of(const Design& design, int yarn, double firm_sett, Units units) {
  constexpr double kSame_mm = 0.001;
  const Yarn& of = design.yarns[static_cast<size_t>(yarn)];
  const MeanThread warp = mean_thread(design, System::kWarp, yarn), weft = mean_thread(design, System::kWeft, yarn);
  const auto print = [&](const std::string& name, const MeanThread& thread) {
    print_wraps(name, thread.tex, thread.spun_mm, firm_sett, units);
  };
  if (warp.threads == 0 && weft.threads == 0)
    return print_wraps(of.name, static_cast<double>(tex_of(of)), spun_diameter_mm(of, of.diameter_mm), firm_sett,
                       units);
  if (warp.threads == 0 || weft.threads == 0 || std::abs(warp.diameter_mm - weft.diameter_mm) < kSame_mm)
    return print(of.name, warp.threads > 0 ? warp : weft);
  print(fill(tr("{yarn} in the warp"), arg("yarn", of.name)), warp);
  print(fill(tr("{yarn} in the weft"), arg("yarn", of.name)), weft);
}

void print_setts(const Design& design, const DraftAnalysis& f, Units units) {
  const ClothMeasures m = cloth_measures(design);
  print_row(tr("sett"), fill(tr("{ends}, {picks}"), arg("ends", sett_text(m.draft_ends_per_cm, System::kWarp, units)),
                             arg("picks", sett_text(m.draft_picks_per_cm, System::kWeft, units))));
  for (size_t yarn = 0; yarn < design.yarns.size(); ++yarn)
    print_wraps_of(design, static_cast<int>(yarn), f.firm_sett, units);
}

std::string difference_text(const Difference& d) {
  if (!d.threads.empty()) return thread_list(d.threads);
  if (d.a.empty() && d.b.empty()) return tr("differ");
  return fill(tr("'{first}' and '{second}'"), arg("first", d.a), arg("second", d.b));
}

std::string crossings_text(const Comparison& c) {
  if (c.crossings == 0) return tr("the same where both have threads");
  return fill(tr_n("{count} crossing, in ends {ends} and picks {picks}",
                   "{count} crossings, in ends {ends} and picks {picks}", c.crossings),
              arg("count", c.crossings), arg("ends", fmt::format("{}-{}", c.where.end0 + 1, c.where.end1)),
              arg("picks", fmt::format("{}-{}", c.where.pick0 + 1, c.where.pick1)));
}

}  // namespace

int analyse_command(const AnalyseOptions& options) {
  const OpenedDesign opened = open_design(options.file);
  if (!opened.ok) return kBadInput;
  const std::optional<Design> planned = with_options(opened.design, options.plan);
  if (!planned) return kUsage;
  const DraftAnalysis f = analysis_of(*planned, options);
  if (options.json) {
    std::printf("%s\n", as_json(*planned, f, options).c_str());
    return kDone;
  }
  print_row(tr("repeat"),
            fill(tr("{weave}; with colours {colours}"), arg("weave", threads_text(f.structure.ends, f.structure.picks)),
                 arg("colours", threads_text(f.design.ends, f.design.picks))));
  print_floats(f, options.float_limit);
  print_layers(f);
  print_loom(f);
  print_setts(*planned, f, options.plan.units);
  print_plan(*planned, options.plan.units);
  return kDone;
}

int diff_command(const DiffOptions& options) {
  const OpenedDesign a = open_design(options.a), b = open_design(options.b);
  if (!a.ok || !b.ok) return kBadInput;
  const Comparison c = compare(a.design, b.design);
  for (const Difference& d : c.differences) print_row(tr(d.what.c_str()), difference_text(d));
  if (!c.same_cloth) print_row(tr("drawdown"), crossings_text(c));
  else std::printf("%s\n", c.differences.empty() ? tr("the drafts are the same") : tr("the cloth is the same"));
  return kDone;
}

}  // namespace weftlight::commands
