#include "drape/soft_goods.h"

#include <algorithm>

#include "drape/bodies.h"
#include "drape/vec.h"

namespace weftlight::drape {

namespace {

constexpr int kScarfColumns = 37, kScarfRows = 241;
constexpr float kScarfWidth = 259.2f, kScarfLength = 1728;
constexpr float kScarfRound = 104, kScarfHigh = 1462;  // radius and height of its middle at the start, around the neck

constexpr int kCushionThreads = 63;
constexpr float kCushionSide = 420;

/// A cross-section of the scarf, which is worn folded in three: a sine-generated curve. x: away from the neck, y: along
/// the folds, both from its middle.
Vec2 scarf_folds(float from_middle, float swing) {
  constexpr int kSteps = 96;
  constexpr float kWave = kScarfWidth / 1.5f;
  Vec2 at{};
  for (int k = 0; k < kSteps; ++k) {
    const float there = from_middle * (static_cast<float>(k) + 0.5f) / kSteps;
    const float direction = swing * std::cos(2 * kPi * there / kWave);
    at += Vec2{std::cos(direction), std::sin(direction)} * (from_middle / kSteps);
  }
  return at;
}

/// The path of the scarf from its middle at the nape: a half circle, then straight forwards on both sides. `radius`: of
/// a point; `even`: of the threads there, if the folds were spread evenly, so that no fold is sheared.
Vec3 scarf_path(float along, float radius, float even) {
  const float turn = std::fmin(std::fabs(along) / even, kPi / 2), on = std::fabs(along) - turn * even;
  return {std::copysign(radius * std::sin(turn), along), 0, -radius * std::cos(turn) + on};
}

/// The enclosed volume in mm3.
double volume_of(const Pattern& pattern, const SimulatedCloth& cloth) {
  double six_volumes = 0;
  const auto at = [&](size_t i) { return cloth.position[pattern.particle[pattern.index[i]]] - cloth.position[0]; };
  for (size_t t = 0; t < pattern.index.size(); t += 3) six_volumes += dot(cross(at(t), at(t + 1)), at(t + 2));
  return six_volumes / 6;
}

/// The pressure of the filling, equal on every triangle, as accelerations in mm/s2.
void add_pressure(const Pattern& pattern, double pascal, const SimulatedCloth& cloth,
                  std::vector<Vec3d>& acceleration) {
  acceleration.assign(cloth.position.size(), Vec3d{});
  const double n_per_mm2 = 1e-6 * pascal;
  for (size_t t = 0; t < pattern.index.size(); t += 3) {
    std::array<uint32_t, 3> p{};
    for (size_t k = 0; k < 3; ++k) p[k] = pattern.particle[pattern.index[t + k]];
    const Vec3d doubled =
        cross(cloth.position[p[1]] - cloth.position[p[0]], cloth.position[p[2]] - cloth.position[p[0]]);
    for (const uint32_t particle : p)
      acceleration[particle] += doubled * (n_per_mm2 / 6 * 1000 * cloth.inverse_mass[particle]);
  }
}

Piece add_cushion_side(Pattern& pattern, bool back) {
  const auto shape = [](float s, float t) { return Vec2{s * kCushionSide, t * kCushionSide}; };
  const auto place = [=](Vec2 uv) {
    const float s = 2 * uv[0] / kCushionSide - 1, t = 2 * uv[1] / kCushionSide - 1;
    const float bulge = 4 + 46 * std::sqrt(std::fmax(0.0f, (1 - s * s) * (1 - t * t)));
    const float uneven = 1.5f * std::sin(0.13f * uv[0] + 1) * std::sin(0.11f * uv[1]);
    const float side = back ? -1.0f : 1.0f, half = 0.475f * kCushionSide;
    const Vec3 lying{side * half * s, side * (bulge + uneven) + 62, -half * t - 22};
    return Vec3{0, kBoardHeight, 0} + lean_back(lying, kBoardLean);
  };
  return add_piece(pattern, kCushionThreads, kCushionThreads, shape, place);
}

}  // namespace

Drape scarf() {
  Drape drape;
  const auto shape = [](float s, float t) { return Vec2{s * kScarfWidth, t * kScarfLength}; };
  constexpr float kFolded = 2, kOpen = 1.3f;                        // at the neck, and towards the ends
  const float deep = 2 * scarf_folds(kScarfWidth / 2, kFolded)[0];  // of the three layers
  const auto place = [=](Vec2 uv) {
    const float across = uv[0] - kScarfWidth / 2, along = uv[1] - kScarfLength * 0.53f;
    const Vec2 folds = scarf_folds(across, mix(kFolded, kOpen, ramp(250, 900, std::fabs(along))));
    // Not quite symmetric, as a scarf is thrown on.
    const Vec3 uneven{6 * std::sin(0.011f * uv[1] + 1), 5 * std::sin(0.019f * uv[1]), 4};
    return scarf_path(along, kScarfRound + folds[0], kScarfRound + across / kScarfWidth * deep) + uneven +
           Vec3{0, kScarfHigh - folds[1], 0};
  };
  add_piece(drape.pattern, kScarfColumns, kScarfRows, shape, place);
  put_on_form(drape);
  drape.fall.seconds = 4.5;
  drape.fall.contact_updates_per_second = 320;
  drape.fall.substeps = 10;
  drape.fall.slow_start_s = 1.2;
  drape.fall.cloth_gap_mm = 7.5;
  drape.fabric.crease_per_mm = 0.03;  // it keeps the folds in which it is worn
  drape.fall.body_friction = 0.45;
  drape.fall.drag_per_second = 3.5;
  return drape;
}

Drape cushion() {
  Drape drape;
  Pattern& pattern = drape.pattern;
  const Piece front = add_cushion_side(pattern, false), back = add_cushion_side(pattern, true);
  constexpr int kLast = kCushionThreads - 1;
  for (int i = 0; i <= kLast; ++i) {
    sew(pattern, front.vertex(i, 0), back.vertex(kLast - i, 0));
    sew(pattern, front.vertex(i, kLast), back.vertex(kLast - i, kLast));
    sew(pattern, front.vertex(0, i), back.vertex(kLast, i));
    sew(pattern, front.vertex(kLast, i), back.vertex(0, i));
  }
  drop_unused_particles(pattern);
  drape.body = board;
  drape.smoothing_passes = 2;
  drape.fall.drag_per_second = 4;  // a filling of fibres does not bounce like a gas
  drape.fall.slow_start_s = 0.8;   // filled too fast, a limp one leaps off the board
  drape.fabric.bending_n_m = 0.8e-5;
  drape.fabric.bias_n_per_m = 160;  // with the filling
  drape.fall.seconds = 3;
  drape.fall.cloth_gap_mm = 7;
  drape.fall.body_friction = 1.2;
  drape.fall.accelerate = [pattern](const SimulatedCloth& cloth, double time, std::vector<Vec3d>& acceleration) {
    // A full cushion holds a fifth of the cube of its side; a soft one is filled less.
    constexpr double kPascal = 900, kMax = 15, kSide = kCushionSide, kVolume = 0.165 * kSide * kSide * kSide;
    const double pascal = std::clamp(kPascal * (1 - volume_of(pattern, cloth) / kVolume), 0.0, kMax);
    add_pressure(pattern, pascal * std::fmin(1.0, time / 0.4), cloth, acceleration);
  };
  return drape;
}

}  // namespace weftlight::drape
