#include "ui/ruler.h"

#include <cmath>
#include <cstdint>
#include <iterator>

#include "base/text.h"
#include "ui/widgets.h"

namespace weftlight::ui {
namespace {

constexpr double kCentimetre_mm = 10, kInch_mm = 25.4;

/// Numbers stand every `step` units; `parts`: into how many the marks between them may divide it, most first.
struct Division {
  double step;
  int parts[4];
};
constexpr Division kCentimetres[] = {{0.01, {10, 5, 2, 1}}, {0.02, {4, 2, 1, 1}}, {0.05, {5, 1, 1, 1}},
                                     {0.1, {10, 5, 2, 1}},  {0.2, {4, 2, 1, 1}},  {0.5, {5, 1, 1, 1}},
                                     {1, {10, 5, 2, 1}},    {2, {4, 2, 1, 1}},    {5, {5, 1, 1, 1}}};
constexpr Division kInches[] = {{1.0 / 32, {4, 2, 1, 1}}, {1.0 / 16, {4, 2, 1, 1}}, {0.125, {4, 2, 1, 1}},
                                {0.25, {4, 2, 1, 1}},     {0.5, {8, 4, 2, 1}},      {1, {16, 8, 4, 2}},
                                {2, {8, 4, 2, 1}},        {6, {6, 3, 2, 1}},        {12, {12, 4, 2, 1}},
                                {36, {6, 3, 1, 1}}};

/// "1 1/2"; `unit_parts`: of an inch, a power of two.
std::string fraction_text(int64_t parts, int64_t unit_parts) {
  const int64_t whole = parts / unit_parts;
  int64_t rest = parts % unit_parts;
  while (rest != 0 && rest % 2 == 0) rest /= 2, unit_parts /= 2;
  if (rest == 0) return std::to_string(whole);
  const std::string fraction = std::to_string(rest) + "/" + std::to_string(unit_parts);
  return whole == 0 ? fraction : std::to_string(whole) + " " + fraction;
}

std::string number_text(int64_t index, double step, bool imperial) {
  const double value = static_cast<double>(index) * step;
  if (imperial && step < 1) return fraction_text(std::abs(index), std::llround(1 / step));
  return fixed(static_cast<float>(std::abs(value)), step >= 1 ? 0 : step >= 0.1 ? 1 : 2);
}

/// The smallest division whose numbers do not touch, in units; larger ones than the table's by tens.
Division division_of(const RulerStretch& s, double unit_mm) {
  const auto fits = [&](double step) { return step * unit_mm * s.px_a_mm >= s.label_px; };
  const auto chosen = [&](const auto& table) {
    for (const Division& d : table)
      if (fits(d.step)) return d;
    Division d = table[std::size(table) - 1];
    for (double ten = 10; !fits(d.step) && ten < 1e9; ten *= 10) d = {ten, {10, 5, 2, 1}};
    return d;
  };
  return s.imperial ? chosen(kInches) : chosen(kCentimetres);
}

}  // namespace

const char* ruler_unit(bool imperial) { return imperial ? base::tr_in("inches", "in") : base::tr("cm"); }

std::vector<RulerMark> ruler_marks(const RulerStretch& s) {
  std::vector<RulerMark> marks;
  if (!(s.last_mm > s.first_mm) || !(s.px_a_mm > 0)) return marks;
  const double unit_mm = s.imperial ? kInch_mm : kCentimetre_mm;
  const Division d = division_of(s, unit_mm);
  const double step_mm = d.step * unit_mm;
  if (step_mm * s.px_a_mm < s.label_px) return marks;
  int parts = 1;
  for (const int each : d.parts)
    if (parts == 1 && step_mm * s.px_a_mm >= s.mark_px * each) parts = each;
  const double mark_mm = step_mm / parts;
  constexpr double kRounding = 1e-6;
  const auto first = static_cast<int64_t>(std::ceil(s.first_mm / mark_mm - kRounding));
  const auto last = static_cast<int64_t>(std::floor(s.last_mm / mark_mm + kRounding));
  for (int64_t i = first; i <= last; ++i)
    marks.push_back({static_cast<double>(i) * mark_mm,
                     i % parts == 0 ? number_text(i / parts, d.step, s.imperial) : std::string()});
  return marks;
}

}  // namespace weftlight::ui
