// The skirt: its pattern and its start position around the form.

#include "drape/garments.h"

#include <algorithm>

#include "drape/bodies.h"
#include "drape/vec.h"

namespace weftlight::drape {

namespace {

float ellipse_perimeter(float a, float b) {
  // Ramanujan's first approximation, 1914.
  return kPi * (3 * (a + b) - std::sqrt((3 * a + b) * (a + 3 * b)));
}

/// The angle, from +z to +x, at which `fraction` of the perimeter of an ellipse is covered.
float angle_by_arc(float a, float b, float fraction) {
  constexpr int kSteps = 720;
  float arc = 0;
  const float goal = fraction * ellipse_perimeter(a, b), step = 2 * kPi / kSteps;
  for (int k = 0; k < kSteps; ++k) {
    const float phi = (static_cast<float>(k) + 0.5f) * step;
    const float piece = std::hypot(a * std::cos(phi), b * std::sin(phi)) * step;
    if (arc + piece >= goal) return (static_cast<float>(k) + (goal - arc) / piece) * step;
    arc += piece;
  }
  return 2 * kPi;
}

constexpr int kSkirtColumns = 91, kSkirtRows = 62;
constexpr float kSkirtLength = 590, kPanelAngle = kPi / 2;

struct SkirtCut {
  TrunkSection waist;     // of the cloth, a little outside the form
  float waist_radius;     // radius of the inner arc of the pattern
  float half_width, low;  // so that u and v start at 0
};

SkirtCut skirt_cut() {
  const TrunkSection form = trunk_section(kWaistHeight);
  const TrunkSection waist{form.half_width + 3, form.half_depth + 3, form.middle};
  const float radius = ellipse_perimeter(waist.half_width, waist.half_depth) / 2 / kPanelAngle;
  const float hem = radius + kSkirtLength;
  return {waist, radius, hem * std::sin(kPanelAngle / 2), hem};
}

Piece add_skirt_panel(Pattern& pattern, const SkirtCut& cut, bool back) {
  const auto shape = [=](float s, float t) {
    const float r = cut.waist_radius + (1 - t) * kSkirtLength, phi = (s - 0.5f) * kPanelAngle;
    return Vec2{r * std::sin(phi) + cut.half_width, cut.low - r * std::cos(phi)};
  };
  const auto place = [=](Vec2 uv) {
    const float x = uv[0] - cut.half_width, y = cut.low - uv[1];
    const float down = std::hypot(x, y) - cut.waist_radius, s = std::atan2(x, y) / kPanelAngle;
    const float fraction = (back ? 0.5f : 0.0f) + s / 2;
    const float phi = angle_by_arc(cut.waist.half_width, cut.waist.half_depth, fraction - std::floor(fraction));
    const float flare = 0.55f * down, drop = 0.83f * down;
    return Vec3{
        (cut.waist.half_width + flare) * std::sin(phi), kWaistHeight - drop,
        cut.waist.middle + (cut.waist.half_depth + flare) * std::cos(phi) + 0.01f * down * std::sin(5 * phi + 1)};
  };
  return add_piece(pattern, kSkirtColumns, kSkirtRows, shape, place);
}

}  // namespace

void put_on_form(Drape& drape) {
  drape.body = dress_form;
  drape.lower_mm = kTunicLowered;
  drape.fabric.bending_n_m = 1.4e-5;
  drape.fabric.bias_n_per_m = 45;
}

Drape skirt() {
  Drape drape;
  const SkirtCut cut = skirt_cut();
  const Piece front = add_skirt_panel(drape.pattern, cut, false);
  const Piece back = add_skirt_panel(drape.pattern, cut, true);
  for (int row = 0; row < kSkirtRows; ++row) {
    sew(drape.pattern, front.vertex(kSkirtColumns - 1, row), back.vertex(0, row));
    sew(drape.pattern, front.vertex(0, row), back.vertex(kSkirtColumns - 1, row));
  }
  drop_unused_particles(drape.pattern);
  for (const Piece& panel : {front, back}) {
    for (int column = 0; column < kSkirtColumns; ++column) {
      drape.held.push_back(drape.pattern.particle[panel.vertex(column, kSkirtRows - 1)]);
    }
  }
  drape.body = skirt_form;
  drape.lower_mm = kSkirtLowered;
  drape.fall.cloth_gap_mm = 9;
  drape.fall.body_friction = 0.25;
  return drape;
}

}  // namespace weftlight::drape
