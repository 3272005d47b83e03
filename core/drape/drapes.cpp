// The shipped drapes: the cut of each, its start position, and its body.

#include <algorithm>
#include <optional>

#include "base/mark.h"
#include "drape/bodies.h"
#include "drape/garments.h"
#include "drape/soft_goods.h"
#include "drape/stiffness.h"
#include "drape/vec.h"

namespace weftlight::drape {

using base::mark;

namespace {

PatternShape rectangle(float width_mm, float depth_mm) {
  return [=](float s, float t) { return Vec2{s * width_mm, t * depth_mm}; };
}

/// A small fixed unevenness in mm; without it folds would be perfectly symmetric.
float uneven(float x_mm, float y_mm) {
  return std::sin(0.0113f * x_mm + 0.0041f * y_mm + 0.7f) + std::sin(0.0067f * y_mm - 0.0092f * x_mm + 2.1f) +
         0.5f * std::sin(0.0231f * x_mm - 0.0173f * y_mm + 4.0f);
}

/// A flat square of cloth, its middle near the y axis.
Pattern flat_square(int vertices, float side_mm, float height_mm) {
  Pattern pattern;
  add_piece(pattern, vertices, vertices, rectangle(side_mm, side_mm), [=](Vec2 uv) {
    const float x = uv[0] - side_mm / 2, y = uv[1] - side_mm / 2;
    return Vec3{x + 2, height_mm + 2.5f + uneven(x, y), -y + 1};
  });
  return pattern;
}

Mesh plane() {
  Pattern pattern;
  add_piece(pattern, 31, 21, rectangle(300, 200), [](Vec2 uv) { return Vec3{uv[0] - 150, uv[1], 0}; });
  return to_mesh(pattern, "plane");
}

Drape sphere() {
  Drape drape;
  drape.pattern = flat_square(85, 600, 2 * kBallRadius + 2);
  drape.body = [](Vec3 p) { return std::min(ball(p), ground(p)); };
  drape.fall.seconds = 4;
  drape.fall.drag_per_second = 1;
  drape.fall.body_friction = 0.5;
  drape.fabric.bending_n_m = 0.6e-5;
  drape.fabric.bias_n_per_m = 40;
  drape.fall.cloth_gap_mm = 7;  // limp cloth shears: the diagonals of its cells grow longer
  drape.fall.substeps = 18;
  drape.smoothing_passes = 2;
  return drape;
}

Drape tablecloth() {
  Drape drape;
  drape.pattern = flat_square(101, 1400, kTableHeight + 2);
  drape.body = [](Vec3 p) { return std::min(table(p), ground(p)); };
  drape.fall.seconds = 4;
  drape.fall.cloth_gap_mm = 10.5;
  drape.fabric.bending_n_m = 1.8e-5;
  return drape;
}

Drape curtain() {
  constexpr int kColumns = 99, kRows = 115;
  constexpr float kWidth = 1400, kLength = 1800, kTop = kRodHeight - 2 * kRingRadius;
  Drape drape;
  add_piece(drape.pattern, kColumns, kRows, rectangle(kWidth, kLength), [](Vec2 uv) {
    const float wave = std::sin(uv[0] / kWidth * (kRings - 1) * kPi) * 7 + 3 * uneven(uv[0], uv[1]);
    return Vec3{(uv[0] - kWidth / 2) * 0.995f, kTop - kLength + uv[1], wave};
  });
  drape.body = ground;
  drape.fall.seconds = 5;
  drape.fall.cloth_gap_mm = 11;
  std::vector<uint32_t> held;
  for (int ring = 0; ring < kRings; ++ring) {
    held.push_back(static_cast<uint32_t>((kRows - 1) * kColumns + ring * (kColumns - 1) / (kRings - 1)));
  }
  drape.held = held;
  // The rings slide together along the rod.
  drape.fall.move_held = [held](SimulatedCloth& cloth, double time, double until) {
    for (int ring = 0; ring < kRings; ++ring) {
      const float from = (static_cast<float>(ring) / (kRings - 1) - 0.5f) * kWidth * 0.995f;
      const float gathered = ramp(0, 1.8f, static_cast<float>(until));
      const Vec3d goal{static_cast<double>(mix(from, ring_x(ring), gathered)), static_cast<double>(kTop), 0};
      const uint32_t particle = held[static_cast<size_t>(ring)];
      cloth.velocity[particle] = (goal - cloth.position[particle]) * (1 / (until - time));
    }
  };
  return drape;
}

/// Empty for the plane and for unknown names.
std::optional<Drape> starting_drape(const std::string& name) {
  const std::pair<const char*, Drape (*)()> kDrapes[]{
      {"sphere", sphere}, {"tablecloth", tablecloth}, {"curtain", curtain}, {"skirt", skirt},
      {"tunic", tunic},   {"shirt", shirt},           {"scarf", scarf},     {"cushion", cushion}};
  for (const auto& [known, make] : kDrapes)
    if (name == known) return make();
  return std::nullopt;
}

Mesh finish(Drape drape, const std::string& name, float steps_scale) {
  SimulatedCloth cloth = make_cloth(drape.pattern, drape.fabric, drape.fall.reach_mm());
  for (const uint32_t particle : drape.held) cloth.inverse_mass[particle] = 0;
  drape.fall.seconds *= static_cast<double>(steps_scale);
  simulate(cloth, drape.body, drape.fall);
  for (size_t i = 0; i < cloth.position.size(); ++i) {
    drape.pattern.position_mm[i] = Vec3(cloth.position[i]) - Vec3{0, drape.lower_mm, 0};
  }
  smooth_cell_waves(drape.pattern, drape.smoothing_passes);
  return to_mesh(drape.pattern, name);
}

}  // namespace

const std::vector<std::string>& drape_names() {
  static const std::vector<std::string> names{mark("plane"),   mark("sphere"), mark("tablecloth"),
                                              mark("curtain"), mark("skirt"),  mark("tunic"),
                                              mark("shirt"),   mark("scarf"),  mark("cushion")};
  return names;
}

Mesh simulate_drape(const std::string& name, DrapeStiffness stiffness, float steps_scale) {
  if (name == "plane") return plane();
  std::optional<Drape> drape = starting_drape(name);
  if (!drape) return {};
  drape->fabric = with_stiffness(drape->fabric, stiffness);
  return finish(std::move(*drape), name, steps_scale);
}

Mesh simulate_drape(const std::string& name, const DrapeParameters& parameters,
                    const std::function<bool(double progress)>& keep_going, float steps_scale) {
  std::optional<Drape> drape = starting_drape(name);
  if (!drape) return {};
  apply_parameters(drape->fabric, drape->fall, parameters);
  bool stopped = false;
  drape->fall.keep_going = [&](double progress) { return !keep_going || (stopped = !keep_going(progress), !stopped); };
  Mesh mesh = finish(std::move(*drape), name, steps_scale);
  return stopped ? Mesh{} : mesh;
}

Mesh simulate_drape(const std::string& name, float steps_scale) {
  return simulate_drape(name, DrapeStiffness::kMedium, steps_scale);
}

Mesh body_mesh(const std::string& name) { return mesh_of_body(name); }

}  // namespace weftlight::drape
