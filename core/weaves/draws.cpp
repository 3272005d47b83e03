#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "weaves/families.h"

namespace weftlight::weaves {

using design::Design;
using draft::Draft, draft::blank_draft;

std::vector<int> satin_steps(int shafts) {
  std::vector<int> steps;
  for (int s = 2; s < shafts - 1; ++s)
    if (std::gcd(s, shafts) == 1) steps.push_back(s);
  return steps;
}

Design straight_draw(int shafts, int treadles, ClothSize size) {
  Design design;
  design.draft = blank_draft(size.ends, size.picks, shafts, treadles);
  Draft& d = design.draft;
  for (int end = 0; end < size.ends; ++end) d.threading.set(end, end % shafts, true);
  for (int pick = 0; pick < size.picks; ++pick) d.treadling.set(pick, pick % treadles, true);
  for (int treadle = 0; treadle < treadles; ++treadle)
    for (int k = 0; k < std::max(1, shafts / 2); ++k) d.tieup.set(treadle, (treadle + k) % shafts, true);
  return design;
}

int wave_at(double way, double height) {
  constexpr double kLastBits = 1e-9;
  const double exact = height * (0.5 - 0.5 * std::cos(2 * std::numbers::pi * way));
  return static_cast<int>(std::lround(exact + (way < 0.5 ? -kLastBits : kLastBits)));
}

}  // namespace weftlight::weaves
