#include "design/count.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <utility>

namespace weftlight::design {
namespace {

constexpr double kPound_g = 453.59237, kYard_m = 0.9144;
constexpr double kMin_tex = 0.1, kMax_tex = 100'000;
constexpr double kMost_plies_first = 4;  // "2/28" is of two plies, "12/15" a seine twine of fifteen

/// Grams per kilometre at count 1, for units that count lengths per weight.
double grams_at_one(CountUnit unit) {
  switch (unit) {
    case CountUnit::kNe:
      return kPound_g * 1000 / (840 * kYard_m);
    case CountUnit::kLea:
      return kPound_g * 1000 / (300 * kYard_m);
    default:
      return 1000;
  }
}

struct UnitName {
  std::string_view name;
  CountUnit unit;
};
constexpr std::array<UnitName, 8> kNames{{{"tex", CountUnit::kTex},
                                          {"den", CountUnit::kDenier},
                                          {"denier", CountUnit::kDenier},
                                          {"nm", CountUnit::kNm},
                                          {"ne", CountUnit::kNe},
                                          {"nec", CountUnit::kNe},
                                          {"lea", CountUnit::kLea},
                                          {"nel", CountUnit::kLea}}};

/// Counts lengths per weight, of the singles.
bool is_indirect(CountUnit unit) { return unit == CountUnit::kNe || unit == CountUnit::kNm || unit == CountUnit::kLea; }

/// The number with the fewest digits, up to five, that is as good as the value: within `off`, a fraction of it.
struct Rounded {
  std::string text;
  int digits = 0;
};
Rounded rounded(double value, double off) {
  constexpr int kMaxDigits = 5;
  if (!(value > 0 && std::isfinite(value))) return {"0", kMaxDigits};
  for (int digits = 1; digits <= kMaxDigits; ++digits) {
    const double step = std::pow(10, std::floor(std::log10(value)) + 1 - digits);
    const double near = std::round(value / step) * step;
    if (digits < kMaxDigits && std::abs(near / value - 1) > off) continue;
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", step < 1 ? static_cast<int>(std::lround(-std::log10(step))) : 0, near);
    return {text, digits};
  }
  return {};
}

/// How far a label in the unit of the trade may be from the count, as a fraction.
double label_of(double tex, CountUnit usual) {
  constexpr double kLabel = 5e-4, kFewFigures = 2e-3, kExact = 1e-6;
  // 150 den are noted as 16.7 tex, 300 den as 33.3.
  return usual == CountUnit::kDenier && rounded(tex, kExact).digits <= 3 ? kFewFigures : kLabel;
}

/// Whether a yarn of one trade may be labelled in the unit of another: filament is sold by neither hanks nor leas, and
/// spun yarn not in denier.
bool may_be_sold_in(CountUnit unit, CountUnit usual) {
  if (usual == CountUnit::kTex || unit == CountUnit::kTex) return true;
  if (usual == CountUnit::kDenier) return unit == CountUnit::kNm;
  return unit != CountUnit::kDenier;
}

/// What of the yarn the number of a label counts: singles where the unit is of lengths per weight.
double number_of(double tex, int plies, CountUnit unit) {
  return count_of(is_indirect(unit) ? tex / std::max(plies, 1) : tex, unit);
}

std::string labelled(std::string number, int plies, CountUnit unit) {
  if (is_indirect(unit) && plies > 1) number.append("/").append(std::to_string(plies));
  switch (unit) {
    case CountUnit::kNe:
      return "Ne " + number;
    case CountUnit::kNm:
      return "Nm " + number;
    case CountUnit::kLea:
      return number + " lea";
    case CountUnit::kDenier:
      return number + " den";
    default:
      return number + " tex";
  }
}

bool is_number(char c) { return (c >= '0' && c <= '9') || c == '.'; }

/// The letters of the text in lower case, and the other characters without blanks.
struct CountText {
  std::string word, number;
};
CountText split(std::string_view text) {
  CountText p;
  for (const char c : text) {
    if (std::isalpha(static_cast<unsigned char>(c))) p.word += static_cast<char>(std::tolower(c));
    else if (c != ' ' && c != '\t') p.number += c;
  }
  return p;
}

std::optional<double> number_in(std::string_view text) {
  double value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || !is_number(text.front()) || fault != std::errc() || end != text.data() + text.size())
    return std::nullopt;
  return value;
}

}  // namespace

double tex_of(double count, CountUnit unit) {
  if (unit == CountUnit::kTex) return count;
  if (unit == CountUnit::kDenier) return count / 9;
  return grams_at_one(unit) / count;
}

double count_of(double tex, CountUnit unit) {
  if (unit == CountUnit::kTex) return tex;
  if (unit == CountUnit::kDenier) return tex * 9;
  return grams_at_one(unit) / tex;
}

std::optional<WrittenCount> read_count(std::string_view text) {
  if (text.size() > 64) return std::nullopt;
  const CountText p = split(text);
  const size_t stroke = p.number.find('/');
  const bool plied = stroke != std::string::npos;
  std::optional<double> count = number_in(std::string_view(p.number).substr(0, stroke));
  std::optional<double> plies = plied ? number_in(std::string_view(p.number).substr(stroke + 1)) : 1.0;
  if (!count || !plies) return std::nullopt;
  if (plied && *count <= kMost_plies_first && *plies > kMost_plies_first) std::swap(count, plies);
  if (*count <= 0 || *plies < 1 || *plies > 64 || *plies != std::floor(*plies)) return std::nullopt;
  for (const UnitName& known : kNames) {
    if (known.name != p.word) continue;
    const double tex = tex_of(*count, known.unit) * *plies;
    if (tex < kMin_tex || tex > kMax_tex) return std::nullopt;
    return WrittenCount{tex, plied ? static_cast<int>(*plies) : is_indirect(known.unit) ? 1 : 0};
  }
  return std::nullopt;
}

std::optional<double> tex_from_text(std::string_view text) {
  const std::optional<WrittenCount> count = read_count(text);
  return count ? std::optional(count->tex) : std::nullopt;
}

std::string count_text(double tex, int plies, CountUnit usual) {
  constexpr CountUnit kUnits[] = {CountUnit::kTex, CountUnit::kNe, CountUnit::kNm, CountUnit::kLea, CountUnit::kDenier};
  constexpr int kPlain = 2;  // digits: nobody would write it otherwise
  // What was typed in another unit is kept in four figures of tex at least; what is further off is near it by chance.
  constexpr double kTyped = 2.5e-4;
  CountUnit best = usual;
  Rounded fewest = rounded(number_of(tex, plies, usual), label_of(tex, usual));
  for (const CountUnit unit : kUnits) {
    if (fewest.digits <= kPlain && best == usual) break;
    if (!may_be_sold_in(unit, usual)) continue;
    if (const Rounded other = rounded(number_of(tex, plies, unit), kTyped); other.digits < fewest.digits)
      best = unit, fewest = other;
  }
  return labelled(fewest.text, plies, best);
}

std::string about_count_text(double tex, int plies, CountUnit unit) {
  constexpr double kThreeFigures = 5e-3;
  return labelled(rounded(number_of(tex, plies, unit), kThreeFigures).text, plies, unit);
}

double diameter_from_tex_mm(double tex, double density_g_cm3, double packing) {
  return 2 * std::sqrt(tex / (1000 * std::numbers::pi * density_g_cm3 * packing));
}

double tex_from_diameter(double diameter_mm, double density_g_cm3, double packing) {
  return 250 * std::numbers::pi * density_g_cm3 * packing * diameter_mm * diameter_mm;
}

}  // namespace weftlight::design
