// The figure of presets/cloths/damask.wif: a half-drop ogee lattice with a rosette and a lily in its fields. It is
// symmetric in both directions, so that a quarter of it gives the blocks of five shafts.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recipes.h"
#include "weaves/weaves.h"

namespace weftlight::wif {

using design::Design;
using weaves::Recipe, weaves::make_design;

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kAcross = 48, kUp = 64;  // units of five threads in a quarter of the figure
constexpr float kSquash = 0.8f;        // flowers are a little taller than wide
constexpr float kFlower = 30;          // radius, units

struct Polar {
  float radius, angle;  // units, radians
};
Polar polar(float x, float y) { return {std::hypot(x, kSquash * y), std::atan2(kSquash * y, x)}; }

/// 1 in the middle of one of `count` petals, 0 between two; `turn`: rotation in petals.
float petal(float angle, float count, float turn = 0) {
  const float at = angle * count / (2 * kPi) + turn;
  return 1 - 2 * std::abs(at - std::round(at));
}

/// The stem of the ogee at a distance inside it (units; negative: outside) and a height of 0 to 1: a thick line, a thin
/// line beside it, three leaves on the inner side.
bool stem(float inside, float height) {
  const float along = height * 3 - std::floor(height * 3);
  const float leaf = 1.5f + 8 * std::sin(kPi * along) * std::pow(along, 0.6f);
  if (std::abs(inside) < 1.2f) return true;
  if (inside > 0 && inside < leaf && height > 0.08f && height < 0.92f)
    return along < 0.2f || std::abs(inside - leaf / 2) > 0.5f;
  return inside > -4.4f && inside < -2.8f;
}

/// Eight veined petals and the tips of eight behind them, around an eye.
bool rosette(Polar at) {
  const float r = at.radius / kFlower, front = petal(at.angle, 8), back = petal(at.angle, 8, 0.5f);
  if (r < 0.28f) return r < 0.1f || (r > 0.16f && r < 0.22f);
  const bool vein = (1 - front) * kPi / 8 * at.radius < 0.8f && r > 0.4f && r < 0.8f * std::pow(front, 0.3f);
  if (r < 0.46f + 0.54f * std::pow(front, 0.75f)) return !vein && (front > 0.1f || r < 0.42f);
  return r < 0.4f + 0.5f * std::pow(back, 1.2f) && r > 0.52f + 0.54f * std::pow(front, 0.75f);
}

/// Four hollow petals with a heart each, four small ones between them.
bool lily(Polar at) {
  const float r = at.radius / kFlower, wide = petal(at.angle, 4), between = petal(at.angle, 4, 0.5f);
  if (at.radius < 5) return at.radius < 3;
  if (r < 0.1f + 0.6f * std::pow(wide, 2.4f)) return true;
  if (r < 0.22f + 0.64f * std::pow(wide, 1.5f)) return false;
  return r < std::max(0.34f + 0.66f * std::pow(wide, 1.1f), 0.2f + 0.42f * std::pow(between, 1.6f));
}

/// Whether the figure covers that unit of the quarter, counted from its middle.
bool figured(int column, int row) {
  const float x = static_cast<float>(column) + 0.5f, y = static_cast<float>(row) + 0.5f;
  const float turn = kPi * y / kUp, edge = kAcross / 2.0f * (1 + std::cos(turn));
  const float slant = kAcross / 2.0f * kPi / kUp * std::sin(turn);
  return stem((edge - x) / std::hypot(1.0f, slant), y / kUp) ||
         (x < edge ? rosette(polar(x, y)) : lily(polar(kAcross - x, kUp - y)));
}

/// Shafts or treadles in order, five per unit: forwards through a quarter and back.
std::vector<int> there_and_back(int units) {
  std::vector<int> out;
  for (int unit = 0; unit < 2 * units; ++unit)
    for (int s = 0; s < 5; ++s) out.push_back(5 * (unit < units ? units - 1 - unit : unit - units) + s);
  return out;
}

}  // namespace

Design figured_damask() {
  constexpr int kShafts = 5, kStep = 2;
  Recipe r;
  r.shafts = kShafts * kAcross;
  r.threading = there_and_back(kAcross), r.treadling = there_and_back(kUp);
  for (int treadle = 0; treadle < kShafts * kUp; ++treadle) {
    std::vector<int> lifts;
    for (int shaft = 0; shaft < r.shafts; ++shaft) {
      const bool bound = shaft * kStep % kShafts == treadle % kShafts;
      if (bound != figured(shaft / kShafts, treadle / kShafts)) lifts.push_back(shaft);
    }
    r.tieup.push_back(lifts);
  }
  return make_design(r, {static_cast<int>(r.threading.size()), static_cast<int>(r.treadling.size())});
}

}  // namespace weftlight::wif
