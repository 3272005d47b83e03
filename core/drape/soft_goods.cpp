#include "drape/soft_goods.h"

#include <algorithm>

#include "drape/bodies.h"
#include "drape/vec.h"

namespace weftlight::drape {

namespace {

constexpr int kScarfColumns = 41, kScarfRows = 217;
constexpr float kScarfWidth = 320, kScarfLength = 1728;
constexpr float kScarfLow = 1412;  // its lower edge, as it is laid round the neck

constexpr int kCushionThreads = 63;
constexpr float kCushionSide = 420;

/// Along the scarf from its middle at the nape: a half circle, then straight forwards on both sides.
Vec3 scarf_path(float along, float radius) {
  const float turn = std::fmin(std::fabs(along) / radius, kPi / 2), on = std::fabs(along) - turn * radius;
  const float side = along < 0 ? -1.0f : 1.0f;
  return {side * radius * std::sin(turn), 0, -radius * std::cos(turn) + on};
}

/// What is inside, in mm3.
double volume_of(const Pattern& pattern, const Cloth& cloth) {
  double six_volumes = 0;
  const auto at = [&](size_t i) { return cloth.position[pattern.particle[pattern.index[i]]] - cloth.position[0]; };
  for (size_t t = 0; t < pattern.index.size(); t += 3) six_volumes += dot(cross(at(t), at(t + 1)), at(t + 2));
  return six_volumes / 6;
}

/// Where the filling pushes: an even pressure on every triangle, as accelerations in mm/s2.
void press_out(const Pattern& pattern, double pascal, const Cloth& cloth, std::vector<Vec3d>& push) {
  push.assign(cloth.position.size(), Vec3d{});
  const double n_per_mm2 = 1e-6 * pascal;
  for (size_t t = 0; t < pattern.index.size(); t += 3) {
    std::array<uint32_t, 3> p{};
    for (size_t k = 0; k < 3; ++k) p[k] = pattern.particle[pattern.index[t + k]];
    const Vec3d doubled =
        cross(cloth.position[p[1]] - cloth.position[p[0]], cloth.position[p[2]] - cloth.position[p[0]]);
    for (const uint32_t particle : p) push[particle] += doubled * (n_per_mm2 / 6 * 1000 * cloth.inverse_mass[particle]);
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
    return Vec3{0, kBoardHeight, 0} + turned_back(lying, kBoardLean);
  };
  return add_piece(pattern, kCushionThreads, kCushionThreads, shape, place);
}

}  // namespace

Drape scarf() {
  Drape drape;
  const auto shape = [](float s, float t) { return Vec2{s * kScarfWidth, t * kScarfLength}; };
  const auto place = [](Vec2 uv) {
    const float up = uv[0] / kScarfWidth, along = uv[1] - kScarfLength * 0.53f;
    // Wider at the top, as it is thrown on; uneven, as no hand lays it alike on both sides.
    const Vec3 p = scarf_path(along, 92 + 40 * up);
    return p + Vec3{6 * std::sin(0.011f * uv[1] + 1), kScarfLow + uv[0] * 0.97f + 5 * std::sin(0.019f * uv[1]), 4};
  };
  add_piece(drape.pattern, kScarfColumns, kScarfRows, shape, place);
  wear(drape);
  drape.fall.seconds = 4.5;
  drape.fall.substeps = 20;
  drape.fall.apart_mm = 6.5;
  drape.fall.body_friction = 0.45;
  drape.fall.air_per_second = 3.5;
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
  drape.fall.air_per_second = 4;  // a filling that is no gas does not bounce
  drape.fabric.bending_n_m = 0.8e-5;
  drape.fabric.bias_n_per_m = 100;
  drape.fall.seconds = 3;
  drape.fall.apart_mm = 6;
  drape.fall.body_friction = 1.2;
  drape.fall.push = [pattern](const Cloth& cloth, double time, std::vector<Vec3d>& push) {
    // A full one would hold a fifth of its side's cube; soft ones are filled less.
    constexpr double kPascal = 900, kMax = 70, kSide = kCushionSide, kVolume = 0.165 * kSide * kSide * kSide;
    const double pascal = std::clamp(kPascal * (1 - volume_of(pattern, cloth) / kVolume), 0.0, kMax);
    press_out(pattern, pascal * std::fmin(1.0, time / 0.1), cloth, push);
  };
  return drape;
}

}  // namespace weftlight::drape
