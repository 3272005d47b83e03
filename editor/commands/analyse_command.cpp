// `analyse` and `diff`: what a draft is as a weave and on a loom, and what two drafts differ in.

#include <charconv>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "analysis/difference.h"
#include "analysis/floats.h"
#include "analysis/threads.h"
#include "analysis/weave_layers.h"
#include "commands/commands.h"
#include "draft/factor.h"
#include "draft/fibre.h"
#include "draft/repeat.h"

namespace weftlight::commands {
namespace {

using Json = nlohmann::ordered_json;

struct DraftAnalysis {
  Repeat structure, design;
  LongestFloats longest;
  LongFloats floats;
  std::vector<Layer> layers;
  LoomUse loom;
  LoomSize fewest;
  Interlacing interlacings;
  double warp_share = 0;
  YarnReport yarn;
};

/// None: no price.
std::optional<double> price_in(std::string_view text) {
  constexpr double kMax = 1e6;
  double price = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), price);
  if (error != std::errc() || end != text.data() + text.size() || !(price >= 0 && price <= kMax)) return {};
  return price;
}

std::string names_of(const std::vector<Yarn>& yarns) {
  std::string names;
  for (const Yarn& yarn : yarns) names += (names.empty() ? "" : ", ") + yarn.name;
  return names;
}

/// What is wrong with a price, or empty. Of yarns of one name all have it.
std::string take_price(const Design& design, std::string_view text, ClothPlan& plan) {
  const size_t equals = text.rfind('=');
  const bool for_all = equals == std::string_view::npos;
  const std::optional<double> price = price_in(for_all ? text : text.substr(equals + 1));
  if (!price) return "give YARN=PRICE, or PRICE for all yarns: 0 to 1000000 a kilogram";
  bool known = false;
  for (size_t i = 0; i < design.yarns.size(); ++i) {
    if (!for_all && design.yarns[i].name != text.substr(0, equals)) continue;
    plan.price_per_kg[i] = *price;
    known = true;
  }
  return known ? "" : "the draft's yarns are " + names_of(design.yarns);
}

/// False, with a line on stderr, when one is no price, or of a yarn that is not there. Later ones win.
bool take_prices(const Design& design, const std::vector<std::string>& prices, ClothPlan& plan) {
  plan.price_per_kg.resize(design.yarns.size(), -1);
  for (const std::string& one : prices) {
    const std::string wrong = take_price(design, one, plan);
    if (wrong.empty()) continue;
    std::fprintf(stderr, "weftlight: --price %s: %s\n", one.c_str(), wrong.c_str());
    return false;
  }
  return true;
}

DraftAnalysis analysis_of(const Design& design, const AnalyseOptions& options) {
  const BitMatrix cells = drawdown(design.draft);
  return {structure_repeat(cells), design_repeat(design, cells),
          longest_floats(cells),   long_floats(cells, options.float_limit),
          layers(cells),           loom_use(design.draft),
          fewest_for(cells),       interlacing(cells),
          warp_up_share(cells),    yarn_report(design, options.plan)};
}

const char* name_of(System system) { return system == System::kWarp ? "warp" : "weft"; }
const char* name_of(Face face) { return face == Face::kFront ? "front" : "back"; }

std::vector<int> from_one(std::vector<int> threads) {
  for (int& thread : threads) ++thread;
  return threads;
}

const Rgb& color_of(const Design& design, const YarnNeed& need) {
  return design.draft.palette[static_cast<size_t>(need.color)];
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
  for (const Layer& layer : f.layers)
    list.push_back({{"loose", layer.loose()}, {"ends", from_one(layer.ends)}, {"picks", from_one(layer.picks)}});
  return list;
}

Json yarn_json(const Design& design, const YarnReport& yarn) {
  Json needs = Json::array();
  for (const YarnNeed& need : yarn.needs) {
    const Rgb& c = color_of(design, need);
    Json one = {{"system", name_of(need.system)}, {"yarn", design.yarns[static_cast<size_t>(need.yarn)].name},
                {"color", {c.r, c.g, c.b}},       {"threads", need.threads},
                {"length_m", need.length_m},      {"weight_g", need.weight_g}};
    one["tex"] = tex_of(design.yarns[static_cast<size_t>(need.yarn)]);
    if (need.cost >= 0) one["cost"] = need.cost;
    needs.push_back(one);
  }
  Json json = {{"ends", yarn.ends},
               {"picks", yarn.picks},
               {"ends_per_cm", yarn.ends_per_cm},
               {"picks_per_cm", yarn.picks_per_cm},
               {"loom_width_mm", yarn.loom_width_mm},
               {"warp_length_mm", yarn.warp_length_mm},
               {"warp_m", yarn.warp_m},
               {"weft_m", yarn.weft_m},
               {"weight_g", yarn.weight_g},
               {"g_per_m2", yarn.g_per_m2},
               {"needs", needs}};
  if (yarn.cost >= 0) json["cost"] = yarn.cost;
  return json;
}

std::string as_json(const Design& design, const DraftAnalysis& f, const AnalyseOptions& options) {
  const Json json = {{"repeat",
                      {{"ends", f.structure.ends},
                       {"picks", f.structure.picks},
                       {"with_colors", {{"ends", f.design.ends}, {"picks", f.design.picks}}}}},
                     {"floats", floats_json(f, options.float_limit)},
                     {"layers", layers_json(f)},
                     {"hangs_together", f.layers.size() <= 1},
                     {"heddles", f.loom.heddles},
                     {"lifts", f.loom.lifts},
                     {"treads", f.loom.treads},
                     {"unthreaded_ends", f.loom.unthreaded_ends},
                     {"empty_picks", f.loom.empty_picks},
                     {"fewest", {{"shafts", f.fewest.shafts}, {"treadles", f.fewest.treadles}}},
                     {"balance",
                      {{"warp_on_top", f.warp_share},
                       {"warp_interlacing", f.interlacings.warp},
                       {"weft_interlacing", f.interlacings.weft}}},
                     {"yarn", yarn_json(design, f.yarn)}};
  // Names come from files and may be cut anywhere.
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

void print_layers(const DraftAnalysis& f) {
  if (f.layers.size() <= 1) return void(std::printf("hangs together  yes\n"));
  std::printf("hangs together  no: %zu layers, front to back\n", f.layers.size());
  for (const Layer& layer : f.layers) {
    const char* kind = !layer.loose() ? "layer" : layer.ends.empty() ? "loose pick" : "loose end";
    std::printf("  %s:", kind);
    if (!layer.ends.empty()) std::printf(" ends %s;", listed(layer.ends).c_str());
    if (!layer.picks.empty()) std::printf(" picks %s", listed(layer.picks).c_str());
    std::printf("\n");
  }
}

void print_floats(const DraftAnalysis& f, int limit) {
  std::printf("longest float   warp %d front, %d back; weft %d front, %d back\n", f.longest.warp_front,
              f.longest.warp_back, f.longest.weft_front, f.longest.weft_back);
  std::printf("floats over %-3d %lld\n", limit, static_cast<long long>(f.floats.count));
  constexpr size_t kShown = 20;
  for (size_t i = 0; i < f.floats.listed.size() && i < kShown; ++i) {
    const Float& x = f.floats.listed[i];
    std::printf("  %s %d, %s, from %s %d: %d\n", x.system == System::kWarp ? "end" : "pick", x.thread + 1,
                name_of(x.face), x.system == System::kWarp ? "pick" : "end", x.first + 1, x.length);
  }
  if (f.floats.listed.size() > kShown) std::printf("  ... all with --json\n");
}

void print_loom(const DraftAnalysis& f) {
  std::printf("heddles         ");
  for (size_t s = 0; s < f.loom.heddles.size(); ++s)
    std::printf("%s%zu: %d", s > 0 ? ", " : "", s + 1, f.loom.heddles[s]);
  std::printf("\nfewest          %d shafts, %d treadles\n", f.fewest.shafts, f.fewest.treadles);
  if (f.loom.unthreaded_ends > 0) std::printf("on no shaft     %d ends\n", f.loom.unthreaded_ends);
  if (f.loom.empty_picks > 0) std::printf("nothing lifted  %d picks\n", f.loom.empty_picks);
  std::printf("balance         warp on top %.0f %%; interlacing warp %.2f, weft %.2f\n", f.warp_share * 100,
              f.interlacings.warp, f.interlacings.weft);
}

void print_yarn(const Design& design, const DraftAnalysis& f) {
  const YarnReport& y = f.yarn;
  std::printf("sett            %.1f ends/cm, %.1f picks/cm\n", y.ends_per_cm, y.picks_per_cm);
  for (size_t i = 0; i < design.yarns.size(); ++i) {
    const double wraps = wraps_per_cm(design.yarns[i].diameter_mm);
    std::printf("  from wraps    %s: %.1f tex, %.1f wraps/cm, sett %.1f/cm\n", design.yarns[i].name.c_str(),
                static_cast<double>(tex_of(design.yarns[i])), wraps, sett_per_cm(wraps, f.interlacings.weft));
  }
  std::printf("on the loom     %lld ends, %.0f mm wide, warp %.2f m long; %lld picks\n", static_cast<long long>(y.ends),
              y.loom_width_mm, y.warp_length_mm / 1000, static_cast<long long>(y.picks));
  std::printf("yarn            warp %.1f m, weft %.1f m, %.1f g; %.0f g/m2 finished\n", y.warp_m, y.weft_m, y.weight_g,
              y.g_per_m2);
  for (const YarnNeed& need : y.needs) {
    const Rgb& c = color_of(design, need);
    const auto byte = [](float channel) { return static_cast<int>(channel * 255 + 0.5f); };
    std::printf("  %s %-16s #%02x%02x%02x %6lld threads %9.1f m %8.1f g", name_of(need.system),
                design.yarns[static_cast<size_t>(need.yarn)].name.c_str(), byte(c.r), byte(c.g), byte(c.b),
                static_cast<long long>(need.threads), need.length_m, need.weight_g);
    if (need.cost >= 0) std::printf(" %9.2f", need.cost);
    std::printf("\n");
  }
  if (y.cost >= 0) std::printf("cost            %.2f\n", y.cost);
}

}  // namespace

int analyse_command(const AnalyseOptions& options) {
  const OpenedDesign opened = open_design(options.file);
  if (!opened.ok) return kBadInput;
  AnalyseOptions priced = options;
  if (!take_prices(opened.design, options.prices, priced.plan)) return kUsage;
  const DraftAnalysis f = analysis_of(opened.design, priced);
  if (options.json) {
    std::printf("%s\n", as_json(opened.design, f, options).c_str());
    return kDone;
  }
  std::printf("repeat          %d ends, %d picks; with colours %d ends, %d picks\n", f.structure.ends,
              f.structure.picks, f.design.ends, f.design.picks);
  print_floats(f, options.float_limit);
  print_layers(f);
  print_loom(f);
  print_yarn(opened.design, f);
  return kDone;
}

int diff_command(const DiffOptions& options) {
  const OpenedDesign a = open_design(options.a), b = open_design(options.b);
  if (!a.ok || !b.ok) return kBadInput;
  const Comparison c = compare(a.design, b.design);
  for (const Difference& d : c.differences) {
    if (!d.threads.empty()) std::printf("%-15s %s\n", d.what.c_str(), listed(d.threads).c_str());
    else if (d.a.empty() && d.b.empty()) std::printf("%-15s differ\n", d.what.c_str());
    else std::printf("%-15s '%s' and '%s'\n", d.what.c_str(), d.a.c_str(), d.b.c_str());
  }
  if (c.same_cloth) {
    std::printf(c.differences.empty() ? "the drafts are the same\n" : "the cloth is the same\n");
  } else if (c.crossings > 0) {
    std::printf("%-15s %lld crossings, in ends %d-%d and picks %d-%d\n", "drawdown",
                static_cast<long long>(c.crossings), c.where.end0 + 1, c.where.end1, c.where.pick0 + 1, c.where.pick1);
  } else {
    std::printf("%-15s the same where both have threads\n", "drawdown");
  }
  return kDone;
}

}  // namespace weftlight::commands
