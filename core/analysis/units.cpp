#include "analysis/units.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "base/decimals.h"
#include "base/text.h"

namespace weftlight::analysis {

using base::arg, base::fill, base::tr;
using design::kMaxDents;

namespace {

struct LengthUnit {
  std::string_view name;
  double mm;
};
constexpr std::array<LengthUnit, 9> kLengthUnits{{{"", 1},
                                                  {"mm", 1},
                                                  {"cm", 10},
                                                  {"m", 1000},
                                                  {"in", kInch_mm},
                                                  {"inch", kInch_mm},
                                                  {"\"", kInch_mm},
                                                  {"ft", 12 * kInch_mm},
                                                  {"yd", 36 * kInch_mm}}};

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// Removes the number at the start of the text.
std::optional<double> taken_number(std::string_view& text) {
  text = without_blanks(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc() || !std::isfinite(value) || value < 0) return std::nullopt;
  text = without_blanks(text.substr(static_cast<size_t>(read.ptr - text.data())));
  return value;
}

std::string shown(const char* pattern, double value) { return fill(pattern, arg("value", value)); }

/// What is there is not said to be nothing: `least` below the least amount that the pattern can write.
std::string amount(const char* pattern, double value, double least_value, const char* least) {
  return value > 0 && value < least_value ? std::string(least) : shown(pattern, value);
}

/// Dents as they stand on the reed: without a fraction if there is none.
std::string dents_text(float dents) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", static_cast<double>(dents));
  return base::with_decimal_point(text);
}

}  // namespace

std::string width_text(double mm, Units units) {
  return units == Units::kMetric ? shown(tr("{value:.1f} cm"), mm / 10) : shown(tr("{value:.1f} in"), mm / kInch_mm);
}

std::string short_length_text(double mm, Units units) {
  return units == Units::kMetric ? shown(tr("{value:.0f} mm"), mm) : shown(tr("{value:.2f} in"), mm / kInch_mm);
}

std::string warp_length_text(double mm, Units units) {
  return units == Units::kMetric ? shown(tr("{value:.2f} m"), mm / 1000)
                                 : shown(tr("{value:.2f} yd"), mm / 1000 / kYard_m);
}

std::string yarn_length_text(double m, Units units) {
  if (units == Units::kImperial) return amount(tr("{value:.0f} yd"), m / kYard_m, 1, tr("under 1 yd"));
  return m < 5000 ? amount(tr("{value:.0f} m"), m, 1, tr("under 1 m")) : shown(tr("{value:.1f} km"), m / 1000);
}

std::string weight_text(double g, Units units) {
  if (units == Units::kMetric)
    return g < 1000 ? amount(tr("{value:.0f} g"), g, 1, tr("under 1 g")) : shown(tr("{value:.2f} kg"), g / 1000);
  return g < kPound_g ? amount(tr("{value:.2f} oz"), g / kOunce_g, 0.01, tr("under 0.01 oz"))
                      : shown(tr("{value:.2f} lb"), g / kPound_g);
}

std::string area_weight_text(double g_per_m2, Units units) {
  return units == Units::kMetric ? shown(tr("{value:.0f} g/m\xC2\xB2"), g_per_m2)
                                 : shown(tr("{value:.1f} oz/yd\xC2\xB2"), g_per_m2 * kYard_m * kYard_m / kOunce_g);
}

std::string sett_text(double per_cm, System system, Units units) {
  const bool warp = system == System::kWarp;
  if (units == Units::kMetric)
    return shown(warp ? tr("{value:.1f} ends per cm") : tr("{value:.1f} picks per cm"), per_cm);
  return shown(warp ? tr("{value:.1f} ends per inch") : tr("{value:.1f} picks per inch"), per_cm * kInch_mm / 10);
}

std::string reed_text(const Reed& reed) {
  const std::string dents = dents_text(reed.dents);
  return reed.per_inch ? fill(tr("{dents} dents per inch"), arg("dents", dents)) : dents + "/10";
}

std::optional<double> length_mm_from_text(std::string_view text) {
  const std::optional<double> number = taken_number(text);
  if (!number) return std::nullopt;
  for (const LengthUnit& unit : kLengthUnits)
    if (unit.name == text) return *number * unit.mm;
  return std::nullopt;
}

std::optional<Reed> reed_from_text(std::string_view text) {
  const std::optional<double> dents = taken_number(text);
  if (!dents || !(*dents > 0 && *dents <= static_cast<double>(kMaxDents))) return std::nullopt;
  if (text != "/10" && text != "/in" && text != "/inch" && text != "dpi") return std::nullopt;
  return Reed{static_cast<float>(*dents), text != "/10"};
}

}  // namespace weftlight::analysis
