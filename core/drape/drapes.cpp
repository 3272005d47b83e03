// The shipped drapes: what is cut, where it starts and what it falls on.

#include <algorithm>
#include <cmath>

#include "drape/pattern.h"
#include "drape/vec.h"

namespace weftlight {

using namespace draping;

const std::vector<std::string>& drape_names() {
  static const std::vector<std::string> names{"plane", "sphere", "tablecloth", "curtain", "skirt", "tunic"};
  return names;
}

namespace {

PatternShape rectangle(float width_mm, float depth_mm) {
  return [=](float s, float t) { return Vec2{s * width_mm, t * depth_mm}; };
}

/// Over a round form: flat to `flat`, down its shoulder, then hanging in folds.
Placement over_round(float half_mm, float radius, float top, int folds) {
  return [=](Vec2 uv) {
    const float x = uv[0] - half_mm, y = uv[1] - half_mm;
    const float r = std::sqrt(x * x + y * y), phi = std::atan2(y, x);
    const float bend = 60;
    const float past = std::max(r - (radius - bend), 0.0f);
    const float angle = std::min(past / bend, kPi / 2);
    const float hang = std::max(past - bend * kPi / 2, 0.0f);
    const float fold = 0.25f * hang * std::cos(static_cast<float>(folds) * phi);
    const float out = std::min(r, radius - bend) + bend * std::sin(angle) + 0.25f * hang + fold;
    const float height = std::max(top - bend * (1 - std::cos(angle)) - 0.9f * hang, 2.0f);
    return Vec3{out * std::cos(phi), height, -out * std::sin(phi)};
  };
}

Placement around(float radius, float flare, float top) {
  return [=](Vec2 uv) {
    const float phi = uv[0] / 1400 * 2 * kPi, down = 600 - uv[1];
    const float out = radius + flare * down * (1 + 0.4f * std::cos(10 * phi));
    return Vec3{out * std::sin(phi), top - down, out * std::cos(phi)};
  };
}

}  // namespace

Mesh simulate_drape(const std::string& name, float) {
  Pattern pattern;
  const auto cut = [&](float width, float depth, const Placement& place) {
    add_piece(pattern, 101, 101, rectangle(width, depth), place);
  };
  if (name == "plane") {
    add_piece(pattern, 31, 21, rectangle(300, 200), [](Vec2 uv) { return Vec3{uv[0] - 150, uv[1], 0}; });
  } else if (name == "sphere") {
    cut(600, 600, over_round(300, 150, 300, 8));
  } else if (name == "tablecloth") {
    cut(1400, 1400, over_round(700, 450, 722, 14));
  } else if (name == "curtain") {
    cut(1400, 1800, [](Vec2 uv) {
      return Vec3{(uv[0] - 700) * 0.6f, uv[1] + 50, 50 * std::sin(uv[0] * 2 * kPi / 170)};
    });
  } else if (name == "skirt") {
    cut(1400, 600, around(120, 0.35f, 1050));
  } else if (name == "tunic") {
    cut(1400, 600, around(200, 0.05f, 1400));
  }
  return to_mesh(pattern, name);
}

Mesh body_mesh(const std::string& name) {
  Mesh mesh;
  mesh.name = name + "_body";
  return mesh;
}

}  // namespace weftlight
