// Constraints of the simulated cloth from its pattern.
// Based on: Bergou, Wardetzky, Harmon, Zorin, Grinspun, "A Quadratic Bending Model for Inextensible
// Surfaces", SGP 2006 (the weights of a bend, equation 6 with the areas in the stiffness).
// Differs: lengths and angles are those of the flat pattern, so a seam bends like cloth without a seam.

#include "drape/fabric.h"

#include <algorithm>
#include <map>
#include <queue>

namespace weftlight::drape {

namespace {

constexpr double kInterlining_n_m = 1e-5;  // of an interlining of firmness 2, for every fabric

/// A side of a triangle, in the order of that triangle.
struct Side {
  uint32_t start, end, far;  // vertices
  float firmness;
};

using EdgeSides = std::map<std::pair<uint32_t, uint32_t>, std::vector<Side>>;

/// The sides of all triangles by the pair of particles that they join, in ascending order.
EdgeSides collect_sides(const Pattern& pattern) {
  EdgeSides sides;
  for (size_t t = 0; t < pattern.index.size(); t += 3) {
    for (size_t k = 0; k < 3; ++k) {
      Side side{pattern.index[t + k], pattern.index[t + (k + 1) % 3], pattern.index[t + (k + 2) % 3],
                pattern.firmness[t / 3]};
      if (pattern.particle[side.start] > pattern.particle[side.end]) std::swap(side.start, side.end);
      sides[{pattern.particle[side.start], pattern.particle[side.end]}].push_back(side);
    }
  }
  return sides;
}

Vec2 edge(const Pattern& pattern, uint32_t from, uint32_t to) { return pattern.uv_mm[to] - pattern.uv_mm[from]; }

double twice_area(Vec2 a, Vec2 b) { return std::fabs(static_cast<double>(a[0] * b[1] - a[1] * b[0])); }

double cotangent(Vec2 a, Vec2 b) {
  return static_cast<double>(a[0] * b[0] + a[1] * b[1]) / std::max(twice_area(a, b), 1e-6);
}

/// Stiff along the threads and soft along the bias: the compliance is mixed by sin^2 of twice the angle.
Stretch make_stretch(const Pattern& pattern, const Side& side, const Fabric& fabric) {
  const Vec2 d = edge(pattern, side.start, side.end);
  const double rest = static_cast<double>(length(d));
  const double sine = 2 * static_cast<double>(d[0] * d[1]) / (rest * rest);
  const double bias = sine * sine;
  return {pattern.particle[side.start], pattern.particle[side.end], rest,
          (1 - bias) / fabric.thread_n_per_m + bias / fabric.bias_n_per_m};
}

Bend make_bend(const Pattern& pattern, const Side& one, const Side& two, const Fabric& fabric) {
  const auto corner = [&](const Side& side) {
    const Vec2 along = edge(pattern, side.start, side.end);
    const double at_start = cotangent(along, edge(pattern, side.start, side.far));
    const double at_end = cotangent(edge(pattern, side.end, side.start), edge(pattern, side.end, side.far));
    const double area = 0.5 * twice_area(along, edge(pattern, side.start, side.far));
    return std::array{at_start, at_end, area};
  };
  const auto [start1, end1, area1] = corner(one);
  const auto [start2, end2, area2] = corner(two);
  Bend bend;
  bend.particle = {pattern.particle[one.start], pattern.particle[one.end], pattern.particle[one.far],
                   pattern.particle[two.far]};
  bend.weight = {end1 + end2, start1 + start2, -(start1 + end1), -(start2 + end2)};
  const double mm2_per_m2 = 1e6;
  const double firmness = static_cast<double>(std::min(one.firmness, two.firmness));
  const double stiffness =
      fabric.bending_n_m * std::min(firmness, 1.0) + kInterlining_n_m * std::max(firmness - 1, 0.0);
  bend.compliance = (area1 + area2) / (3 * stiffness * mm2_per_m2);
  if (fabric.crease_per_mm > 0 && firmness == 1) bend.yield_mm = fabric.crease_per_mm * 2 * (area1 + area2) / 3;
  return bend;
}

std::vector<double> inverse_masses(const Pattern& pattern, const Fabric& fabric) {
  std::vector<double> mass(pattern.position_mm.size(), 0.0);
  for (size_t t = 0; t < pattern.index.size(); t += 3) {
    const uint32_t* v = &pattern.index[t];
    const double area_mm2 = 0.5 * twice_area(edge(pattern, v[0], v[1]), edge(pattern, v[0], v[2]));
    for (int k = 0; k < 3; ++k) mass[pattern.particle[v[k]]] += fabric.kg_per_m2 * area_mm2 * 1e-6 / 3;
  }
  for (double& m : mass) m = 1 / m;
  return mass;
}

/// Finds the particles within near_mm of each particle, along the edges of the cloth (Dijkstra).
void find_near(SimulatedCloth& cloth, double near_mm) {
  const size_t count = cloth.position.size();
  std::vector<std::vector<std::pair<uint32_t, double>>> links(count);
  for (const Stretch& s : cloth.stretches) {
    links[s.a].push_back({s.b, s.rest_mm});
    links[s.b].push_back({s.a, s.rest_mm});
  }
  cloth.near_first.push_back(0);
  for (uint32_t i = 0; i < count; ++i) {
    std::map<uint32_t, double> reached;
    std::priority_queue<std::pair<double, uint32_t>> open;
    open.push({0.0, i});
    while (!open.empty()) {
      const auto [minus_distance, at] = open.top();
      open.pop();
      if (!reached.emplace(at, -minus_distance).second) continue;
      for (const auto& [to, step] : links[at]) {
        if (step - minus_distance < near_mm) open.push({minus_distance - step, to});
      }
    }
    for (const auto& [particle, distance] : reached) cloth.near.push_back(particle);
    cloth.near_first.push_back(static_cast<uint32_t>(cloth.near.size()));
  }
}

}  // namespace

SimulatedCloth make_cloth(const Pattern& pattern, const Fabric& fabric, double near_mm) {
  SimulatedCloth cloth;
  for (const Vec3& p : pattern.position_mm) cloth.position.push_back(Vec3d(p));
  cloth.velocity.assign(cloth.position.size(), Vec3d{});
  cloth.inverse_mass = inverse_masses(pattern, fabric);
  for (const auto& [particles, sides] : collect_sides(pattern)) {
    Stretch stretch = make_stretch(pattern, sides[0], fabric);
    if (sides.size() == 2) {
      // The shorter side rules: the longer one is gathered into it.
      const Stretch other = make_stretch(pattern, sides[1], fabric);
      if (other.rest_mm < stretch.rest_mm) stretch = other;
    }
    cloth.stretches.push_back(stretch);
    const bool is_seam = sides.size() == 2 && sides[0].start != sides[1].start && sides[0].end != sides[1].end;
    if (is_seam) cloth.stretches.back().rest_mm *= 1 - fabric.pucker;
    if (sides.size() == 2) cloth.bends.push_back(make_bend(pattern, sides[0], sides[1], fabric));
  }
  find_near(cloth, near_mm);
  return cloth;
}

void set_creases(SimulatedCloth& cloth, double fraction) {
  for (Bend& bend : cloth.bends) {
    if (!(bend.yield_mm > 0)) continue;
    const auto at = [&](size_t k) { return cloth.position[bend.particle[k]]; };
    const Vec3d edge = at(1) - at(0), both = cross(edge, at(2) - at(0)) + cross(at(3) - at(0), edge);
    const double l = length(both);
    if (l < 1e-9) continue;
    Vec3d sum{};
    for (size_t k = 0; k < 4; ++k) sum += at(k) * bend.weight[k];
    const double more = dot(sum, both) / l - bend.set_mm;
    bend.set_mm += fraction * std::copysign(std::max(std::abs(more) - bend.yield_mm, 0.0), more);
    bend.rest = both * (bend.set_mm / l);
  }
}

}  // namespace weftlight::drape
