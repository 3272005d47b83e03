// Patterns of the garments, and how they are put round the form before they fall.

#include "drape/garments.h"

#include <algorithm>

#include "drape/bodies.h"
#include "drape/vec.h"

namespace weftlight::draping {

namespace {

float ellipse_perimeter(float a, float b) {
  // Ramanujan's first approximation, 1914.
  return kPi * (3 * (a + b) - std::sqrt((3 * a + b) * (a + 3 * b)));
}

/// The angle at which a point that has gone `share` of an ellipse's way round stands, from +z to +x.
float angle_by_arc(float a, float b, float share) {
  constexpr int kSteps = 720;
  float gone = 0;
  const float goal = share * ellipse_perimeter(a, b), step = 2 * kPi / kSteps;
  for (int k = 0; k < kSteps; ++k) {
    const float phi = (static_cast<float>(k) + 0.5f) * step;
    const float piece = std::hypot(a * std::cos(phi), b * std::sin(phi)) * step;
    if (gone + piece >= goal) return (static_cast<float>(k) + (goal - gone) / piece) * step;
    gone += piece;
  }
  return 2 * kPi;
}

constexpr int kSkirtColumns = 91, kSkirtRows = 62;
constexpr float kSkirtLength = 590, kPanelAngle = kPi / 2;

struct SkirtCut {
  Section waist;         // the cloth's, a little outside the form
  float waist_radius;    // of the pattern's inner arc
  float half_width, low;  // so that u and v start at 0
};

SkirtCut skirt_cut() {
  const Section form = trunk_section(kWaistHeight);
  const Section waist{form.half_width + 3, form.half_depth + 3, form.middle};
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
    const float share = (back ? 0.5f : 0.0f) + s / 2;
    const float phi = angle_by_arc(cut.waist.half_width, cut.waist.half_depth, share - std::floor(share));
    const float flare = 0.55f * down, drop = 0.83f * down;
    return Vec3{(cut.waist.half_width + flare) * std::sin(phi), kWaistHeight - drop,
                cut.waist.middle + (cut.waist.half_depth + flare) * std::cos(phi) +
                    0.01f * down * std::sin(5 * phi + 1)};
  };
  return add_piece(pattern, kSkirtColumns, kSkirtRows, shape, place);
}

constexpr float kBodyHalf = 295, kBodyLength = 720;  // half the panel's width; hem to neck point
constexpr float kNeckHalf = 92, kShoulderDrop = 62, kArmhole = 215;
constexpr int kBodyColumns = 61, kBodyRows = 71, kSleeveRows = 44;
constexpr float kSleeveLength = 430, kCuffShare = 0.74f;
constexpr float kShoulderHeight = 1436;  // of the neck point

/// Top edge of a body panel above its hem: shoulder, and neckline `dip` deep.
float body_top(float x, float dip) {
  const float out = std::max(std::fabs(x) - kNeckHalf, 0.0f) / (kBodyHalf - kNeckHalf);
  const float in = std::min(std::fabs(x) / kNeckHalf, 1.0f);
  return kBodyLength - kShoulderDrop * out - dip * std::pow(1 - in * in, 0.7f);
}

Piece add_body_panel(Pattern& pattern, bool back) {
  const float dip = back ? 22 : 88;
  const auto shape = [=](float s, float t) {
    const float x = (2 * s - 1) * kBodyHalf;
    return Vec2{x + kBodyHalf, t * body_top(x, dip)};
  };
  const auto place = [=](Vec2 uv) {
    const float x = uv[0] - kBodyHalf, below = body_top(x, 0) - uv[1];
    const float across = std::sqrt(std::max(1 - x * x / (kBodyHalf * kBodyHalf), 0.0f));
    const float depth = 150 * across * ramp(-60, 130, below) + 8 * ramp(0, 60, below);
    const float z = -12 + (back ? -depth : depth);
    return Vec3{back ? -x : x, kShoulderHeight - (kBodyLength - uv[1]), z};
  };
  return add_piece(pattern, kBodyColumns, kBodyRows, shape, place);
}

/// Rows of a body panel's side from the hem to the armhole.
int armhole_row() {
  const float side = body_top(kBodyHalf, 0);
  return static_cast<int>(std::lround((side - kArmhole) / side * (kBodyRows - 1)));
}

/// A tube along the arm: s from the underarm round over the top, t from cuff to armhole.
Piece add_sleeve(Pattern& pattern, float side, int columns) {
  const float armhole = 2 * static_cast<float>(kBodyRows - 1 - armhole_row()) *
                        body_top(kBodyHalf, 0) / (kBodyRows - 1);
  const auto shape = [=](float s, float t) {
    return Vec2{armhole * (0.5f + (s - 0.5f) * mix(kCuffShare, 1, t)), t * kSleeveLength};
  };
  const Arm a = arm();
  const auto place = [=](Vec2 uv) {
    const float t = uv[1] / kSleeveLength, girth = armhole * mix(kCuffShare, 1, t);
    const float s = (uv[0] - armhole * 0.5f) / girth + 0.5f;
    const Vec3 axis = unit(a.wrist - a.shoulder);
    const Vec3 over = unit(Vec3{-axis[1], axis[0], 0}), front{0, 0, 1};
    const float beta = 2 * kPi * s, radius = girth / (2 * kPi);
    // A mirrored sleeve runs round the other way.
    const Vec3 round = over * (-std::cos(beta) * radius) + front * (side * std::sin(beta) * radius);
    Vec3 p = a.shoulder + axis * (95 + (1 - t) * kSleeveLength) + round;
    p[0] *= side;
    return p;
  };
  return add_piece(pattern, columns, kSleeveRows, shape, place);
}

void sew_tube(Pattern& pattern, const Piece& sleeve) {
  for (int row = 0; row < sleeve.rows; ++row) {
    sew(pattern, sleeve.vertex(0, row), sleeve.vertex(sleeve.columns - 1, row));
  }
}

}  // namespace

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
  drape.fall.apart_mm = 8;
  drape.fall.body_friction = 0.25;
  return drape;
}

Drape tunic() {
  Drape drape;
  Pattern& pattern = drape.pattern;
  const Piece front = add_body_panel(pattern, false), back = add_body_panel(pattern, true);
  const int underarm = armhole_row(), last = kBodyColumns - 1, top = kBodyRows - 1, rise = top - underarm;
  const Piece right = add_sleeve(pattern, 1, 2 * rise + 1), left = add_sleeve(pattern, -1, 2 * rise + 1);
  for (int row = 0; row <= underarm; ++row) {
    sew(pattern, front.vertex(last, row), back.vertex(0, row));
    sew(pattern, front.vertex(0, row), back.vertex(last, row));
  }
  for (int column = 0; column <= last; ++column) {
    const float x = (2 * static_cast<float>(column) / static_cast<float>(last) - 1) * kBodyHalf;
    if (std::fabs(x) >= kNeckHalf) sew(pattern, front.vertex(column, top), back.vertex(last - column, top));
  }
  sew_tube(pattern, right);
  sew_tube(pattern, left);
  for (int k = 0; k <= 2 * rise; ++k) {
    const int row = k <= rise ? underarm + k : underarm + 2 * rise - k;
    const bool first_half = k <= rise;
    sew(pattern, first_half ? front.vertex(last, row) : back.vertex(0, row), right.vertex(k, kSleeveRows - 1));
    sew(pattern, first_half ? back.vertex(last, row) : front.vertex(0, row), left.vertex(k, kSleeveRows - 1));
  }
  drop_unused_particles(pattern);
  drape.body = dress_form;
  drape.lower_mm = kTunicLowered;
  drape.fabric.bending_n_m = 1.0e-5;
  drape.fabric.bias_n_per_m = 45;
  drape.fall.apart_mm = 6;
  drape.fall.body_friction = 0.3;
  return drape;
}

}  // namespace weftlight::draping
