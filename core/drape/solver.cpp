// Position-based cloth: each substep predicts, then moves particles onto their constraints once.
// Based on: Macklin, Mueller, Chentanez, "XPBD: Position-Based Simulation of Compliant Constrained
// Dynamics", MIG 2016 (equation 18); Macklin et al., "Small Steps in Physics Simulation", SCA 2019
// (one pass a substep); friction as in Macklin et al., "Unified Particle Physics", 2014, section 6.1.
// Differs: contacts are planes and pairs found once for several substeps. Passes keep one direction:
// alternating it makes light particles under load swing between the two answers.

#include "drape/solver.h"

#include <algorithm>

#include "drape/pairs.h"

namespace weftlight::drape {

namespace {

constexpr double kGravity = 9810;   // mm/s2
constexpr double kMaxSpeed = 4000;  // mm/s, cloth falling through air hardly exceeds it

/// The body near a particle, as a plane: normal . x >= offset.
struct Plane {
  uint32_t particle;
  Vec3d normal;
  double offset;
};

struct Contacts {
  std::vector<Plane> planes;
  std::vector<Pair> pairs;
  std::vector<Vec3d> push;  // what Fall::push gave; empty: nothing pushes
};

struct Surface {
  Vec3 normal;
  float distance;
};

/// First-order distance: value over slope.
Surface measure(const Distance& body, Vec3 p) {
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

void find_planes(const Cloth& cloth, const Distance& body, const Fall& how, std::vector<Plane>& planes) {
  planes.clear();
  const double look_s = 1.0 / how.looks_per_second;
  for (uint32_t i = 0; i < cloth.position.size(); ++i) {
    if (cloth.inverse_mass[i] == 0) continue;
    const double reach = how.skin_mm + 4 + 1.5 * length(cloth.velocity[i]) * look_s;
    const Vec3 p = Vec3(cloth.position[i]);
    if (static_cast<double>(body(p)) > 3 * reach) continue;
    const Surface surface = measure(body, p);
    if (static_cast<double>(surface.distance) > reach) continue;
    const Vec3d normal = Vec3d(surface.normal);
    const double along = dot(normal, cloth.position[i]);
    planes.push_back({i, normal, along - static_cast<double>(surface.distance) + how.skin_mm});
  }
}

void solve(const Stretch& s, Cloth& cloth, double per_dt2) {
  const double wa = cloth.inverse_mass[s.a], wb = cloth.inverse_mass[s.b];
  const Vec3d d = cloth.position[s.b] - cloth.position[s.a];
  const double l = length(d);
  if (wa + wb == 0 || l < 1e-9) return;
  const double step = (l - s.rest_mm) / (l * (wa + wb + s.compliance * per_dt2));
  cloth.position[s.a] += d * (wa * step);
  cloth.position[s.b] -= d * (wb * step);
}

void solve(const Bend& b, Cloth& cloth, double per_dt2) {
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

/// The part of `moved` that friction takes back, given how deep the contact was.
Vec3d rubbed(Vec3d moved, Vec3d normal, double depth, double friction) {
  const Vec3d slide = moved - normal * dot(moved, normal);
  const double l = length(slide);
  return l < 1e-12 ? Vec3d{} : slide * std::min(1.0, friction * depth / l);
}

void solve(const Plane& plane, Cloth& cloth, const std::vector<Vec3d>& before, double friction) {
  Vec3d& p = cloth.position[plane.particle];
  const double depth = plane.offset - dot(plane.normal, p);
  if (depth <= 0) return;
  p += plane.normal * depth;
  p -= rubbed(p - before[plane.particle], plane.normal, depth, friction);
}

void solve(const Pair& pair, Cloth& cloth, const std::vector<Vec3d>& before, const Fall& how) {
  const double wa = cloth.inverse_mass[pair.a], wb = cloth.inverse_mass[pair.b];
  const Vec3d d = cloth.position[pair.b] - cloth.position[pair.a];
  const double squared = dot(d, d);
  if (squared >= how.apart_mm * how.apart_mm || squared < 1e-12 || wa + wb == 0) return;
  const double l = std::sqrt(squared);
  const double depth = how.apart_mm - l;
  const Vec3d normal = d * (1 / l);
  const double share_a = wa / (wa + wb), share_b = wb / (wa + wb);
  cloth.position[pair.a] -= normal * (depth * share_a);
  cloth.position[pair.b] += normal * (depth * share_b);
  const Vec3d moved = (cloth.position[pair.b] - before[pair.b]) - (cloth.position[pair.a] - before[pair.a]);
  const Vec3d back = rubbed(moved, normal, depth, how.cloth_friction);
  cloth.position[pair.a] += back * share_a;
  cloth.position[pair.b] -= back * share_b;
}

void predict(Cloth& cloth, const std::vector<Vec3d>& push, double dt, double keep) {
  for (size_t i = 0; i < cloth.position.size(); ++i) {
    Vec3d& v = cloth.velocity[i];
    if (cloth.inverse_mass[i] > 0) {
      v[1] -= kGravity * dt;
      if (!push.empty()) v += push[i] * dt;
      v = v * keep;
      const double speed = length(v);
      if (speed > kMaxSpeed) v = v * (kMaxSpeed / speed);
    }
    cloth.position[i] += v * dt;
  }
}

void substep(Cloth& cloth, const Contacts& contacts, const Fall& how, double dt, double keep) {
  const std::vector<Vec3d> before = cloth.position;
  predict(cloth, contacts.push, dt, keep);
  const double per_dt2 = 1 / (dt * dt);
  for (const Bend& bend : cloth.bends) solve(bend, cloth, per_dt2);
  for (const Stretch& stretch : cloth.stretches) solve(stretch, cloth, per_dt2);
  for (const Pair& pair : contacts.pairs) solve(pair, cloth, before, how);
  for (const Plane& plane : contacts.planes) solve(plane, cloth, before, how.body_friction);
  for (size_t i = 0; i < cloth.position.size(); ++i) {
    if (cloth.inverse_mass[i] > 0) cloth.velocity[i] = (cloth.position[i] - before[i]) * (1 / dt);
  }
}

}  // namespace

void fall(Cloth& cloth, const Distance& body, const Fall& how) {
  const int looks = std::max(1, static_cast<int>(how.seconds * how.looks_per_second));
  Contacts contacts;
  for (int look = 0; look < looks; ++look) {
    if (how.go_on && !how.go_on(look / static_cast<double>(looks))) return;
    const double time = look / static_cast<double>(how.looks_per_second);
    if (how.lead) how.lead(cloth, time, time + 1.0 / how.looks_per_second);
    if (how.push) how.push(cloth, time, contacts.push);
    set_creases(cloth, how.crease_share);
    find_planes(cloth, body, how, contacts.planes);
    find_pairs(cloth, how.reach_mm(), contacts.pairs);
    const bool resting = look > how.rest_from * looks;
    const int substeps = resting && how.rest_substeps > 0 ? how.rest_substeps : how.substeps;
    const double dt = 1.0 / (how.looks_per_second * substeps);
    const double thicker = resting ? 6 : time < how.let_down_s ? 10 : 1;
    const double keep = std::exp(-thicker * how.air_per_second * dt);
    for (int k = 0; k < substeps; ++k) substep(cloth, contacts, how, dt, keep);
  }
}

Vec3 settle(const Distance& body, Vec3 p) {
  for (int pass = 0; pass < 3; ++pass) {
    const Surface surface = measure(body, p);
    p += surface.normal * -surface.distance;
  }
  return p;
}

Vec3 push_out(const Distance& body, Vec3 p, float skin_mm) {
  for (int pass = 0; pass < 3; ++pass) {
    const Surface surface = measure(body, p);
    if (surface.distance >= skin_mm) break;
    p += surface.normal * (skin_mm - surface.distance);
  }
  return p;
}

}  // namespace weftlight::drape
