// Position-based dynamics: each substep predicts the positions, then projects every constraint once.
// Based on: Macklin, Mueller, Chentanez, "XPBD: Position-Based Simulation of Compliant Constrained
// Dynamics", MIG 2016 (equation 18); Macklin et al., "Small Steps in Physics Simulation", SCA 2019
// (one iteration per substep); friction as in Macklin et al., "Unified Particle Physics", 2014, section 6.1.
// Differs: contacts are planes and pairs that are found once for several substeps. Constraints are always solved in the
// same order: alternating it makes light particles under load oscillate between two solutions.

#include "drape/solver.h"

#include <algorithm>

#include "drape/pairs.h"

namespace weftlight::drape {

namespace {

constexpr double kGravity = 9810;   // mm/s2
constexpr double kMaxSpeed = 4000;  // mm/s; cloth that falls through air is hardly faster

/// The body near a particle as a plane: normal . x >= offset.
struct Contact {
  uint32_t particle;
  Vec3d normal;
  double offset;
};

struct Contacts {
  std::vector<Contact> planes;
  std::vector<ParticlePair> pairs;
  std::vector<Vec3d> acceleration;  // from Fall::accelerate; empty: none
};

struct SurfaceDistance {
  Vec3 normal;
  float distance;
};

/// First-order distance: value over gradient.
SurfaceDistance measure(const Distance& body, Vec3 p) {
  constexpr float kStep = 0.5f;
  Vec3 slope;
  for (size_t axis = 0; axis < 3; ++axis) {
    Vec3 ahead = p, behind = p;
    ahead[axis] += kStep;
    behind[axis] -= kStep;
    slope[axis] = (body(ahead) - body(behind)) / (2 * kStep);
  }
  return {unit(slope, {0, 1, 0}), body(p) / std::max(length(slope), 0.2f)};
}

void find_planes(const SimulatedCloth& cloth, const Distance& body, const Fall& settings,
                 std::vector<Contact>& planes) {
  planes.clear();
  const double look_s = 1.0 / settings.contact_updates_per_second;
  for (uint32_t i = 0; i < cloth.position.size(); ++i) {
    if (cloth.inverse_mass[i] == 0) continue;
    const double reach = settings.body_gap_mm + 4 + 1.5 * length(cloth.velocity[i]) * look_s;
    const Vec3 p = Vec3(cloth.position[i]);
    if (static_cast<double>(body(p)) > 3 * reach) continue;
    const SurfaceDistance surface = measure(body, p);
    if (static_cast<double>(surface.distance) > reach) continue;
    const Vec3d normal = Vec3d(surface.normal);
    const double along = dot(normal, cloth.position[i]);
    planes.push_back({i, normal, along - static_cast<double>(surface.distance) + settings.body_gap_mm});
  }
}

void solve(const Stretch& s, SimulatedCloth& cloth, double per_dt2) {
  const double wa = cloth.inverse_mass[s.a], wb = cloth.inverse_mass[s.b];
  const Vec3d d = cloth.position[s.b] - cloth.position[s.a];
  const double l = length(d);
  if (wa + wb == 0 || l < 1e-9) return;
  const double step = (l - s.rest_mm) / (l * (wa + wb + s.compliance * per_dt2));
  cloth.position[s.a] += d * (wa * step);
  cloth.position[s.b] -= d * (wb * step);
}

void solve(const Bend& b, SimulatedCloth& cloth, double per_dt2) {
  Vec3d sum = -b.rest;
  double softness = b.compliance * per_dt2;
  for (size_t k = 0; k < 4; ++k) {
    sum += cloth.position[b.particle[k]] * b.weight[k];
    softness += cloth.inverse_mass[b.particle[k]] * b.weight[k] * b.weight[k];
  }
  for (size_t k = 0; k < 4; ++k) {
    const uint32_t p = b.particle[k];
    cloth.position[p] -= sum * (cloth.inverse_mass[p] * b.weight[k] / softness);
  }
}

/// The part of the motion that friction undoes, for a contact of that depth.
Vec3d friction_step(Vec3d moved, Vec3d normal, double depth, double friction) {
  const Vec3d slide = moved - normal * dot(moved, normal);
  const double l = length(slide);
  return l < 1e-12 ? Vec3d{} : slide * std::min(1.0, friction * depth / l);
}

void solve(const Contact& plane, SimulatedCloth& cloth, const std::vector<Vec3d>& before, double friction) {
  Vec3d& p = cloth.position[plane.particle];
  const double depth = plane.offset - dot(plane.normal, p);
  if (depth <= 0) return;
  p += plane.normal * depth;
  p -= friction_step(p - before[plane.particle], plane.normal, depth, friction);
}

void solve(const ParticlePair& pair, SimulatedCloth& cloth, const std::vector<Vec3d>& before, const Fall& settings) {
  const double wa = cloth.inverse_mass[pair.a], wb = cloth.inverse_mass[pair.b];
  const Vec3d d = cloth.position[pair.b] - cloth.position[pair.a];
  const double squared = dot(d, d);
  if (squared >= settings.cloth_gap_mm * settings.cloth_gap_mm || squared < 1e-12 || wa + wb == 0) return;
  const double l = std::sqrt(squared);
  const double depth = settings.cloth_gap_mm - l;
  const Vec3d normal = d * (1 / l);
  const double weight_a = wa / (wa + wb), weight_b = wb / (wa + wb);
  cloth.position[pair.a] -= normal * (depth * weight_a);
  cloth.position[pair.b] += normal * (depth * weight_b);
  const Vec3d moved = (cloth.position[pair.b] - before[pair.b]) - (cloth.position[pair.a] - before[pair.a]);
  const Vec3d back = friction_step(moved, normal, depth, settings.cloth_friction);
  cloth.position[pair.a] += back * weight_a;
  cloth.position[pair.b] -= back * weight_b;
}

void predict(SimulatedCloth& cloth, const std::vector<Vec3d>& acceleration, double dt, double damping) {
  for (size_t i = 0; i < cloth.position.size(); ++i) {
    Vec3d& v = cloth.velocity[i];
    if (cloth.inverse_mass[i] > 0) {
      v[1] -= kGravity * dt;
      if (!acceleration.empty()) v += acceleration[i] * dt;
      v = v * damping;
      const double speed = length(v);
      if (speed > kMaxSpeed) v = v * (kMaxSpeed / speed);
    }
    cloth.position[i] += v * dt;
  }
}

void substep(SimulatedCloth& cloth, const Contacts& contacts, const Fall& settings, double dt, double damping) {
  const std::vector<Vec3d> before = cloth.position;
  predict(cloth, contacts.acceleration, dt, damping);
  const double per_dt2 = 1 / (dt * dt);
  for (const Bend& bend : cloth.bends) solve(bend, cloth, per_dt2);
  for (const Stretch& stretch : cloth.stretches) solve(stretch, cloth, per_dt2);
  for (const ParticlePair& pair : contacts.pairs) solve(pair, cloth, before, settings);
  for (const Contact& plane : contacts.planes) solve(plane, cloth, before, settings.body_friction);
  for (size_t i = 0; i < cloth.position.size(); ++i) {
    if (cloth.inverse_mass[i] > 0) cloth.velocity[i] = (cloth.position[i] - before[i]) * (1 / dt);
  }
}

}  // namespace

void simulate(SimulatedCloth& cloth, const Distance& body, const Fall& settings) {
  const int updates = std::max(1, static_cast<int>(settings.seconds * settings.contact_updates_per_second));
  Contacts contacts;
  for (int update = 0; update < updates; ++update) {
    if (settings.keep_going && !settings.keep_going(update / static_cast<double>(updates))) return;
    const double time = update / static_cast<double>(settings.contact_updates_per_second);
    if (settings.move_held) settings.move_held(cloth, time, time + 1.0 / settings.contact_updates_per_second);
    if (settings.accelerate) settings.accelerate(cloth, time, contacts.acceleration);
    set_creases(cloth, settings.crease_fraction);
    find_planes(cloth, body, settings, contacts.planes);
    find_pairs(cloth, settings.reach_mm(), contacts.pairs);
    const bool resting = update > settings.rest_from * updates;
    const int substeps = resting && settings.rest_substeps > 0 ? settings.rest_substeps : settings.substeps;
    const double dt = 1.0 / (settings.contact_updates_per_second * substeps);
    const double drag = resting ? 6 : time < settings.slow_start_s ? 10 : 1;
    const double damping = std::exp(-drag * settings.drag_per_second * dt);
    for (int k = 0; k < substeps; ++k) substep(cloth, contacts, settings, dt, damping);
  }
}

Vec3 project_to_surface(const Distance& body, Vec3 p) {
  for (int pass = 0; pass < 3; ++pass) {
    const SurfaceDistance surface = measure(body, p);
    p += surface.normal * -surface.distance;
  }
  return p;
}

}  // namespace weftlight::drape
