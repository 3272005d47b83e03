#include "commands/plan_options.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "analysis/reeds.h"
#include "base/text.h"
#include "commands/exit_codes.h"
#include "commands/open_design.h"
#include "commands/option_checks.h"
#include "design/edits.h"

namespace weftlight::commands {

using analysis::best_sleyed, analysis::kMaxSettDeviation, analysis::kUnitsNames, analysis::length_mm_from_text,
    analysis::reed_from_text, analysis::sett_in_reed, analysis::sett_text, analysis::SleyedReed;
using base::arg, base::fill, base::tr;
using design::ClothPlan, design::Yarn, design::YarnPurchase, design::kMaxClothMm, design::kMaxPieces, design::kMaxPrice,
    design::kMaxSettPerCm, design::kMaxShrinkage, design::kMaxSpare, design::kMaxTakeUp, design::sleying_from_text,
    design::with_plan, design::with_purchase;

namespace {

/// Reads a length with its unit, and leaves millimetres.
CLI::Validator length() {
  return CLI::Validator(
      [](std::string& text) -> std::string {
        const std::optional<double> mm = length_mm_from_text(text);
        if (!mm || *mm > static_cast<double>(kMaxClothMm))
          return fill(tr("{value} is not a length up to 10 km; give mm, or a unit: 500, 50cm, 2.5m, 20in, 3yd"),
                      arg("value", commands::quoted(text)));
        text = std::to_string(*mm);
        return {};
      },
      tr("LENGTH"));
}

CLI::Validator reed_form() {
  return CLI::Validator(
      [](const std::string& text) {
        return reed_from_text(text)
                   ? std::string()
                   : fill(tr("{value} is not a reed; give dents per 10 cm as 40/10, per inch as 12/in"),
                          arg("value", commands::quoted(text)));
      },
      tr("DENTS/10|DENTS/in"));
}

CLI::Validator sleying_form() {
  return CLI::Validator(
      [](const std::string& text) {
        return sleying_from_text(text).empty()
                   ? fill(tr("{value} is not a sleying; give the ends in each dent, as 2 or 1-1-2"),
                          arg("value", commands::quoted(text)))
                   : std::string();
      },
      tr("N-N"));
}

void add_lengths(CLI::App& verb, PlanOptions& o) {
  const auto add = [&](const char* name, std::optional<float>& mm, const char* help) {
    verb.add_option(name, mm, help)->transform(length());
  };
  add("--length", o.length_mm, tr("Length of a finished piece, in mm or with its unit; default: the file's plan"));
  add("--width", o.width_mm, tr("Width of the finished cloth; default: the file's plan"));
  add("--fringe", o.fringe_mm, tr("Warp left unwoven for each piece; default: the file's plan"));
  add("--waste", o.loom_waste_mm, tr("Loom waste, the warp that cannot be woven; default: the file's plan"));
  add("--bout", o.bout_mm, tr("Width of a bout of the warp; default: the file's plan"));
  add("--raddle", o.raddle_mm, tr("Width of a group in the raddle; default: the file's plan"));
}

/// Makes "8%" 0.08; all else is left to the check that follows.
CLI::Validator percentage() {
  return CLI::Validator(
      [](std::string& text) {
        double percent = 0;
        if (!text.ends_with('%')) return std::string();
        const char* const sign = text.data() + text.size() - 1;
        const auto [end, error] = std::from_chars(text.data(), sign, percent);
        if (error == std::errc() && end == sign) text = fmt::format("{:.8g}", percent / 100);
        return std::string();
      },
      "");
}

void add_fractions(CLI::App& verb, PlanOptions& o) {
  // The limit as it is written: 0.9, not the float beside it.
  const auto add_number = [&](const char* name, std::optional<float>& part, float most, const char* help) {
    return verb.add_option(name, part, help)->check(number_in(0.0, std::round(1e6 * static_cast<double>(most)) / 1e6));
  };
  const auto add = [&](const char* name, std::optional<float>& part, float most, const char* help) {
    add_number(name, part, most, help)->transform(percentage());
  };
  add("--shrinkage", o.shrinkage, kMaxShrinkage,
      tr("Shrinkage of length and width, as 8% or 0.08; default: the file's plan"));
  add("--warp-shrinkage", o.warp_shrinkage, kMaxShrinkage, tr("Shrinkage of the length; default: as --shrinkage"));
  add("--weft-shrinkage", o.weft_shrinkage, kMaxShrinkage, tr("Shrinkage of the width; default: as --shrinkage"));
  add("--warp-take-up", o.warp_take_up, kMaxTakeUp,
      tr("How much longer the warp is than the cloth on the loom; default: the file's plan"));
  add("--weft-take-up", o.weft_take_up, kMaxTakeUp,
      tr("Draw-in: how much wider the reed is than the cloth on the loom; default: the file's plan"));
  add("--spare", o.spare, kMaxSpare, tr("Yarn lost in winding and on the bobbins; default: the file's plan"));
  add_number("--ends-per-cm", o.ends_per_cm, kMaxSettPerCm, tr("Desired sett on the loom; default: the file's plan"));
  add_number("--picks-per-cm", o.picks_per_cm, kMaxSettPerCm, tr("Picks on the loom; default: the file's plan"));
}

/// Empty if the text is not a price.
std::optional<float> price_in(std::string_view text) {
  float price = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), price);
  if (error != std::errc() || end != text.data() + text.size() || !(price >= 0 && price <= kMaxPrice)) return {};
  return price;
}

std::string names_of(const std::vector<Yarn>& yarns) {
  std::string names;
  for (const Yarn& yarn : yarns) names += (names.empty() ? "" : ", ") + yarn.name;
  return names;
}

/// Returns what is wrong with the price, or an empty string. Yarns of the same name all get it.
std::string apply_price(Design& design, std::string_view text) {
  const size_t equals = text.rfind('=');
  const bool for_all = equals == std::string_view::npos;
  const std::optional<float> price = price_in(for_all ? text : text.substr(equals + 1));
  if (!price) return tr("give YARN=PRICE, or PRICE for all yarns: 0 to 1000000 per kilogram");
  bool known = false;
  for (const Yarn& yarn : design.yarns) {
    if (!for_all && yarn.name != text.substr(0, equals)) continue;
    design.plan = with_purchase(std::move(design.plan), YarnPurchase{yarn.name, 0, 0, *price});
    known = true;
  }
  return known ? "" : fill(tr("the draft's yarns are {names}"), arg("names", names_of(design.yarns)));
}

void apply_numbers(const PlanOptions& o, ClothPlan& plan) {
  const auto set = [](float& to, const std::optional<float>& from) { to = from.value_or(to); };
  set(plan.width_mm, o.width_mm);
  set(plan.length_mm, o.length_mm);
  set(plan.fringe_mm, o.fringe_mm);
  set(plan.loom_waste_mm, o.loom_waste_mm);
  set(plan.bout_mm, o.bout_mm);
  set(plan.raddle_mm, o.raddle_mm);
  set(plan.warp_shrinkage, o.shrinkage);
  set(plan.weft_shrinkage, o.shrinkage);
  set(plan.warp_shrinkage, o.warp_shrinkage);
  set(plan.weft_shrinkage, o.weft_shrinkage);
  set(plan.warp_take_up, o.warp_take_up);
  set(plan.weft_take_up, o.weft_take_up);
  set(plan.spare, o.spare);
  set(plan.ends_per_cm, o.ends_per_cm);
  set(plan.picks_per_cm, o.picks_per_cm);
  plan.pieces = o.pieces.value_or(plan.pieces);
}

/// Whether the reed with its sleying makes about that sett.
bool makes_sett(const ClothPlan& plan, double ends_per_cm) {
  return std::abs(sett_in_reed(plan.reed, plan.sleying) / ends_per_cm - 1) <= kMaxSettDeviation;
}

/// Reed, sleying and sett, each of which follows from the others: a reed of the file that does not make the sett asked
/// for is left out, and a reed asked for is sleyed to that sett. Returns what cannot be, or an empty string.
std::string apply_reed(const PlanOptions& o, ClothPlan& plan) {
  if (!o.reed.empty()) plan.reed = reed_from_text(o.reed).value_or(design::Reed{});
  if (!o.sleying.empty()) plan.sleying = sleying_from_text(o.sleying);
  const double sett = static_cast<double>(o.ends_per_cm.value_or(0));
  if (sett <= 0 || plan.reed.dents <= 0 || makes_sett(plan, sett)) return {};
  if (o.reed.empty()) {
    plan.reed = {};
    return {};
  }
  if (!o.sleying.empty())
    return fill(tr("--reed {reed} with --sleying {sleying} makes {sett}; leave one of the three out"),
                arg("reed", o.reed), arg("sleying", o.sleying),
                arg("sett", sett_text(sett_in_reed(plan.reed, plan.sleying), draft::System::kWarp, o.units)));
  SleyedReed sleyed = best_sleyed(plan.reed, sett);
  if (sleyed.sleying.empty())
    return fill(tr("no usual sleying of --reed {reed} makes that sett; give another reed, or --sleying instead"),
                arg("reed", o.reed));
  plan.sleying = std::move(sleyed.sleying);
  return {};
}

}  // namespace

void add_units(CLI::App& verb, Units& units) {
  verb.add_option_function<std::string>(
          "--units",
          [&units](const std::string& name) { units = name == kUnitsNames[1] ? Units::kImperial : Units::kMetric; },
          tr("Centimetres and grams, or inches, yards, ounces and pounds; default: metric"))
      ->check(one_of({kUnitsNames[0], kUnitsNames[1]}));
}

void add_plan_options(CLI::App& verb, PlanOptions& o) {
  add_lengths(verb, o);
  verb.add_option("--pieces", o.pieces, tr("Pieces of that length on one warp; default: the file's plan"))
      ->check(whole_number(1, kMaxPieces));
  add_fractions(verb, o);
  verb.add_option("--reed", o.reed, tr("Reed; default: the file's plan"))->check(reed_form());
  verb.add_option("--sleying", o.sleying, tr("Ends in each dent, repeated; default: the file's plan"))
      ->check(sleying_form());
  verb.add_flag("--floating-selvedges", o.floating_selvedges, tr("With an end beside each edge, through no heddle"));
  verb.add_option("--price", o.prices,
                  tr("Price of a kilogram of yarn: YARN=PRICE, or PRICE for all yarns; default: the file's plan"))
      ->type_name(tr("[YARN=]PRICE"));
  add_units(verb, o.units);
}

std::optional<Design> with_options(Design design, const PlanOptions& o) {
  apply_numbers(o, design.plan);
  if (const std::string wrong = apply_reed(o, design.plan); !wrong.empty()) {
    refuse(fill(tr("--ends-per-cm {value}: {problem}"), arg("value", fmt::format("{:g}", *o.ends_per_cm)),
                arg("problem", wrong)));
    return {};
  }
  design.plan.floating_selvedges = design.plan.floating_selvedges || o.floating_selvedges;
  for (const std::string& one : o.prices) {
    const std::string wrong = apply_price(design, one);
    if (wrong.empty()) continue;
    refuse(fill(tr("--price {value}: {problem}"), arg("value", one), arg("problem", wrong)));
    return {};
  }
  ClothPlan plan = design.plan;
  return with_plan(std::move(design), std::move(plan));
}

}  // namespace weftlight::commands
