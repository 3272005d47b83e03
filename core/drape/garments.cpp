// Patterns of the garments, and how they are put round the form before they fall.

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
  Section waist;          // the cloth's, a little outside the form
  float waist_radius;     // of the pattern's inner arc
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
    return Vec3{
        (cut.waist.half_width + flare) * std::sin(phi), kWaistHeight - drop,
        cut.waist.middle + (cut.waist.half_depth + flare) * std::cos(phi) + 0.01f * down * std::sin(5 * phi + 1)};
  };
  return add_piece(pattern, kSkirtColumns, kSkirtRows, shape, place);
}

constexpr float kHemHalf = 305, kShoulderHalf = 238;  // half a body panel's width, below and above
constexpr float kBodyLength = 740;                    // hem to neck point
constexpr float kNeckHalf = 92, kShoulderDrop = 50, kArmhole = 210;
constexpr int kBodyColumns = 63, kBodyRows = 75, kSleeveRows = 42;
constexpr float kSleeveLength = 400, kCuffShare = 0.72f, kCuffAlongArm = 505;
constexpr float kShoulderHeight = 1438;  // of the neck point, before it falls
constexpr float kShoulderMiddle = -12;   // z of the shoulder seam
constexpr float kPutOnHalf = 240;        // half the garment's width when put on

/// Top edge of a body panel above its hem at `across` (-1..1): shoulder, and neckline `dip` deep.
float body_top(float across, float dip) {
  const float x = std::fabs(across) * kShoulderHalf;
  const float out = std::max(x - kNeckHalf, 0.0f) / (kShoulderHalf - kNeckHalf);
  const float in = std::min(x / kNeckHalf, 1.0f);
  return kBodyLength - kShoulderDrop * out - dip * std::pow(1 - in * in, 0.7f);
}

float body_half(float above_hem) { return mix(kHemHalf, kShoulderHalf, std::min(above_hem / kBodyLength, 1.0f)); }

/// How far the armhole gapes to each side at a share of its height, when the sleeve is set in.
float gape(float share) { return 55 * std::sin(kPi * std::clamp(share, 0.0f, 1.0f)); }

constexpr float kSideLength = kBodyLength - kShoulderDrop;
constexpr float kUnderarm = kSideLength - kArmhole;  // above the hem

Piece add_body_panel(Pattern& pattern, bool back) {
  const float dip = back ? 22 : 88;
  const auto shape = [=](float s, float t) {
    const float v = t * body_top(2 * s - 1, dip);
    return Vec2{(2 * s - 1) * body_half(v) + kHemHalf, v};
  };
  const auto place = [=](Vec2 uv) {
    const float across = std::clamp((uv[0] - kHemHalf) / body_half(uv[1]), -1.0f, 1.0f);
    const float round = ramp(0, 130, body_top(across, 0) - uv[1]), angle = across * kPi / 2;
    const float x = kPutOnHalf * mix(across, std::sin(angle), round);
    const float depth = 140 * std::cos(angle) * round + gape((uv[1] - kUnderarm) / kArmhole) * std::pow(across, 4.0f);
    return Vec3{back ? -x : x, kShoulderHeight - (kBodyLength - uv[1]), kShoulderMiddle + (back ? -depth : depth)};
  };
  return add_piece(pattern, kBodyColumns, kBodyRows, shape, place);
}

/// Rows of a body panel's side from the hem to the armhole.
int armhole_row() { return static_cast<int>(std::lround(kUnderarm / kSideLength * (kBodyRows - 1))); }

/// A tube along the arm: s from the underarm round over the top, t from cuff to armhole.
/// A sleeve at -x (side -1) runs round the other way.
Piece add_sleeve(Pattern& pattern, float side, int columns) {
  const float armhole = static_cast<float>(2 * (kBodyRows - 1 - armhole_row())) / (kBodyRows - 1) * kSideLength;
  const auto shape = [=](float s, float t) {
    return Vec2{armhole * (0.5f + (s - 0.5f) * mix(kCuffShare, 1, t)), t * kSleeveLength};
  };
  const Arm a = arm();
  const auto place = [=](Vec2 uv) {
    const float t = uv[1] / kSleeveLength;
    const float s = (uv[0] / armhole - 0.5f) / mix(kCuffShare, 1, t) + 0.5f;
    const float share = 1 - std::fabs(2 * s - 1), around = 2 * kPi * s;
    const float front = s < 0.5f ? side : -side;
    const float above_hem = kUnderarm + share * kArmhole;
    const Vec3 set_in{kPutOnHalf, kShoulderHeight - kBodyLength + above_hem, kShoulderMiddle + front * gape(share)};
    const Vec3 axis = unit(a.wrist - a.shoulder), over = unit(Vec3{-axis[1], axis[0], 0});
    const float radius = armhole * kCuffShare / (2 * kPi);
    const Vec3 cuff = a.shoulder + axis * kCuffAlongArm + over * (-std::cos(around) * radius) +
                      Vec3{0, 0, side * std::sin(around) * radius};
    Vec3 p = cuff * (1 - t) + set_in * t;
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

void wear(Drape& drape) {
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
  drape.fall.apart_mm = 9;
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
    const float across = 2 * static_cast<float>(column) / static_cast<float>(last) - 1;
    if (std::fabs(across) * kShoulderHalf >= kNeckHalf)
      sew(pattern, front.vertex(column, top), back.vertex(last - column, top));
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
  wear(drape);
  drape.fall.apart_mm = 7.5;
  drape.fall.body_friction = 0.3;
  return drape;
}

}  // namespace weftlight::drape
