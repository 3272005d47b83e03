#include "design/count.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

namespace weftlight::design {
namespace {

constexpr double kPound_g = 453.59237, kYard_m = 0.9144;
constexpr double kMin_tex = 0.1, kMax_tex = 100'000;

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

std::optional<double> tex_from_text(std::string_view text) {
  if (text.size() > 64) return std::nullopt;
  const CountText p = split(text);
  const size_t stroke = p.number.find('/');
  const std::optional<double> count = number_in(std::string_view(p.number).substr(0, stroke));
  const std::optional<double> plies =
      stroke == std::string::npos ? 1.0 : number_in(std::string_view(p.number).substr(stroke + 1));
  if (!count || !plies || *count <= 0 || *plies < 1 || *plies > 64) return std::nullopt;
  for (const UnitName& known : kNames) {
    if (known.name != p.word) continue;
    const double tex = tex_of(*count, known.unit) * *plies;
    return tex >= kMin_tex && tex <= kMax_tex ? std::optional(tex) : std::nullopt;
  }
  return std::nullopt;
}

double diameter_from_tex_mm(double tex, double density_g_cm3, double packing) {
  return 2 * std::sqrt(tex / (1000 * std::numbers::pi * density_g_cm3 * packing));
}

double tex_from_diameter(double diameter_mm, double density_g_cm3, double packing) {
  return 250 * std::numbers::pi * density_g_cm3 * packing * diameter_mm * diameter_mm;
}

}  // namespace weftlight::design
