// Smooths waves of the length of a grid cell out of a simulated cloth.
// Based on: Taubin, "A Signal Processing Approach to Fair Surface Design", SIGGRAPH 1995 (two steps, the second one
// negative). Differs: along the normal only, so that threads keep their lengths in flat areas.

#include <algorithm>
#include <array>

#include "drape/pattern.h"
#include "drape/vec.h"

namespace weftlight::drape {

namespace {

struct Edge {
  uint32_t a, b;
  float weight;
  bool border;
};

std::vector<Edge> edges_of(const Pattern& pattern) {
  std::vector<Edge> all;
  for (size_t t = 0; t < pattern.index.size(); ++t) {
    const uint32_t v = pattern.index[t], w = pattern.index[t % 3 == 2 ? t - 2 : t + 1];
    const auto [a, b] = std::minmax(pattern.particle[v], pattern.particle[w]);
    all.push_back({a, b, 1 / std::max(pattern_distance(pattern, v, w), 1e-3f), true});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Edge& x, const Edge& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });
  std::vector<Edge> edges;
  for (const Edge& edge : all) {
    if (!edges.empty() && edges.back().a == edge.a && edges.back().b == edge.b) edges.back().border = false;
    else edges.push_back(edge);
  }
  return edges;
}

std::vector<Vec3> particle_normals(const Pattern& pattern) {
  std::vector<Vec3> normals(pattern.position_mm.size(), Vec3{});
  for (size_t t = 0; t < pattern.index.size(); t += 3) {
    std::array<uint32_t, 3> p;
    for (size_t k = 0; k < 3; ++k) p[k] = pattern.particle[pattern.index[t + k]];
    const Vec3 a = pattern.position_mm[p[0]];
    const Vec3 area = cross(pattern.position_mm[p[1]] - a, pattern.position_mm[p[2]] - a);
    for (const uint32_t i : p) normals[i] += area;
  }
  for (Vec3& n : normals) n = unit(n);
  return normals;
}

void step(Pattern& pattern, const std::vector<Edge>& edges, const std::vector<bool>& on_border, float fraction) {
  std::vector<Vec3> to(pattern.position_mm.size(), Vec3{});
  std::vector<float> sum(to.size(), 0);
  const auto pull = [&](uint32_t at, uint32_t from, const Edge& edge) {
    if (on_border[at] && !edge.border) return;  // a border is smoothed along itself only
    to[at] += edge.weight * (pattern.position_mm[from] - pattern.position_mm[at]);
    sum[at] += edge.weight;
  };
  for (const Edge& edge : edges) pull(edge.a, edge.b, edge), pull(edge.b, edge.a, edge);
  const std::vector<Vec3> normals = particle_normals(pattern);
  for (size_t i = 0; i < to.size(); ++i)
    if (sum[i] > 0) pattern.position_mm[i] += normals[i] * (fraction * dot(to[i], normals[i]) / sum[i]);
}

}  // namespace

void smooth_cell_waves(Pattern& pattern, int passes) {
  // Keeps 99% of a wave of eight cells, and a third or less of one of two cells.
  constexpr float kThere = 0.5f, kBack = -0.526f;
  const std::vector<Edge> edges = edges_of(pattern);
  std::vector<bool> on_border(pattern.position_mm.size(), false);
  for (const Edge& edge : edges)
    if (edge.border) on_border[edge.a] = on_border[edge.b] = true;
  for (int pass = 0; pass < passes; ++pass)
    for (const float fraction : {kThere, kBack}) step(pattern, edges, on_border, fraction);
}

}  // namespace weftlight::drape
