// Rays through a grid of voxels that the triangles fill.

#include "preview/ambient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <meshoptimizer.h>

namespace weftlight {
namespace {

constexpr int kCells = 72;        // along the longest side: folds of a hand's width are resolved
constexpr int kDirections = 40;
constexpr int kGroundSize = 96;
constexpr float kGroundReach = 2.2f;  // half width of the ground's map in bounding radii

glm::vec3 vec(const Vec3& v) { return {v[0], v[1], v[2]}; }

class Voxels {
 public:
  Voxels(glm::vec3 low, glm::vec3 high) {
    const glm::vec3 extent = glm::max(high - low, glm::vec3(1e-3f));
    cell_mm_ = std::max({extent.x, extent.y, extent.z}) / kCells;
    low_ = low - cell_mm_;
    for (int a = 0; a < 3; ++a) count_[a] = static_cast<int>(std::ceil(extent[a] / cell_mm_)) + 2;
    filled_.assign(static_cast<size_t>(count_.x) * count_.y * count_.z, 0);
  }

  float cell_mm() const { return cell_mm_; }

  void fill(const Mesh& mesh) {
    for (size_t i = 0; i + 2 < mesh.index.size(); i += 3) {
      const glm::vec3 a = vec(mesh.position_mm[mesh.index[i]]);
      const glm::vec3 ab = vec(mesh.position_mm[mesh.index[i + 1]]) - a, ac = vec(mesh.position_mm[mesh.index[i + 2]]) - a;
      const float longest = std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab)});
      const int n = std::clamp(static_cast<int>(std::ceil(longest / (0.6f * cell_mm_))), 1, 2 * kCells);
      for (int u = 0; u <= n; ++u) {
        for (int v = 0; v <= n - u; ++v) {
          mark(a + ab * (static_cast<float>(u) / static_cast<float>(n)) + ac * (static_cast<float>(v) / static_cast<float>(n)));
        }
      }
    }
  }

  bool blocked(glm::vec3 from, glm::vec3 along) const {
    const glm::vec3 step = along * 0.9f;
    glm::vec3 at = (from - low_) / cell_mm_;
    for (int i = 0; i < 2 * kCells; ++i, at += step) {
      const glm::ivec3 c(glm::floor(at));
      if (c.x < 0 || c.y < 0 || c.z < 0 || c.x >= count_.x || c.y >= count_.y || c.z >= count_.z) {
        // Outside it can still come in from the side (rays of the ground).
        if (leaves(at, along)) return false;
        continue;
      }
      if (filled_[index(c)]) return true;
    }
    return false;
  }

 private:
  bool leaves(glm::vec3 at, glm::vec3 along) const {
    for (int a = 0; a < 3; ++a) {
      if (at[a] < 0 && along[a] <= 0) return true;
      if (at[a] >= static_cast<float>(count_[a]) && along[a] >= 0) return true;
    }
    return false;
  }
  size_t index(glm::ivec3 c) const { return (static_cast<size_t>(c.z) * count_.y + c.y) * count_.x + c.x; }
  void mark(glm::vec3 p) {
    const glm::ivec3 c = glm::clamp(glm::ivec3(glm::floor((p - low_) / cell_mm_)), glm::ivec3(0), count_ - 1);
    filled_[index(c)] = 1;
  }

  glm::vec3 low_;
  glm::ivec3 count_;
  float cell_mm_ = 1;
  std::vector<uint8_t> filled_;
};

/// Directions about +z, cosine-weighted (a Fibonacci spiral on the disc).
std::array<glm::vec3, kDirections> cosine_directions() {
  std::array<glm::vec3, kDirections> d;
  for (int i = 0; i < kDirections; ++i) {
    const float r2 = (static_cast<float>(i) + 0.5f) / kDirections, r = std::sqrt(r2);
    const float a = 2.39996323f * static_cast<float>(i);
    d[static_cast<size_t>(i)] = {r * std::cos(a), r * std::sin(a), std::sqrt(1 - r2)};
  }
  return d;
}

float seen(const Voxels& voxels, const std::array<glm::vec3, kDirections>& directions, glm::vec3 p, glm::vec3 n,
           float lift_cells) {
  const glm::vec3 helper = std::abs(n.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 t = glm::normalize(glm::cross(helper, n)), b = glm::cross(n, t);
  const glm::vec3 from = p + n * (lift_cells * voxels.cell_mm());
  int open = 0;
  for (const glm::vec3& d : directions) open += !voxels.blocked(from, t * d.x + b * d.y + n * d.z);
  return static_cast<float>(open) / kDirections;
}

/// Means over neighbours, so that the grid does not show.
void smooth(std::vector<SkySeen>& sky, const Mesh& mesh) {
  for (int pass = 0; pass < 3; ++pass) {
    std::vector<SkySeen> sum(sky.size(), SkySeen{0, 0});
    std::vector<float> count(sky.size(), 0);
    for (size_t i = 0; i + 2 < mesh.index.size(); i += 3) {
      for (size_t a = 0; a < 3; ++a) {
        for (size_t b = 0; b < 3; ++b) {
          const uint32_t to = mesh.index[i + a], from = mesh.index[i + b];
          sum[to].front += sky[from].front, sum[to].back += sky[from].back, count[to] += 1;
        }
      }
    }
    for (size_t v = 0; v < sky.size(); ++v) {
      if (count[v] > 0) sky[v] = {sum[v].front / count[v], sum[v].back / count[v]};
    }
  }
}

std::vector<SkySeen> sky_of(const Mesh& mesh, const Voxels& voxels, bool behind) {
  const std::array<glm::vec3, kDirections> directions = cosine_directions();
  std::vector<SkySeen> sky(mesh.position_mm.size());
  for (size_t v = 0; v < sky.size(); ++v) {
    const glm::vec3 p = vec(mesh.position_mm[v]), n = vec(mesh.normal[v]);
    sky[v].front = seen(voxels, directions, p, n, 1.9f);
    sky[v].back = behind ? seen(voxels, directions, p, -n, 1.9f) : 1.0f;
  }
  smooth(sky, mesh);
  return sky;
}

void fill_ground(PreparedMesh& out, const Voxels& voxels) {
  const std::array<glm::vec3, kDirections> directions = cosine_directions();
  out.ground_size = kGroundSize;
  out.ground_half_mm = out.bounds.radius() * kGroundReach;
  out.ground_sky.resize(static_cast<size_t>(kGroundSize) * kGroundSize);
  const glm::vec3 c = out.bounds.centre();
  for (int z = 0; z < kGroundSize; ++z) {
    for (int x = 0; x < kGroundSize; ++x) {
      const float u = (static_cast<float>(x) + 0.5f) / kGroundSize * 2 - 1, v = (static_cast<float>(z) + 0.5f) / kGroundSize * 2 - 1;
      const glm::vec3 p{c.x + u * out.ground_half_mm, out.ground_mm, c.z + v * out.ground_half_mm};
      const float s = seen(voxels, directions, p, glm::vec3(0, 1, 0), 0.6f);
      out.ground_sky[static_cast<size_t>(z) * kGroundSize + x] = static_cast<uint8_t>(s * 255 + 0.5f);
    }
  }
}

/// Fewer triangles over the same vertices, off by at most `error` of the mesh's extent; their texture slides by as much,
/// which is more than a yarn on a table.
std::vector<uint32_t> simplify(const Mesh& mesh, float error) {
  if (mesh.index.empty()) return {};
  std::vector<uint32_t> index(mesh.index.size());
  const size_t count = meshopt_simplify(index.data(), mesh.index.data(), mesh.index.size(), mesh.position_mm[0].data(),
                                        mesh.position_mm.size(), sizeof(Vec3), mesh.index.size() / 16, error);
  index.resize(count);
  return index;
}

}  // namespace

PreparedMesh prepare_mesh(const Mesh& mesh) {
  PreparedMesh out;
  out.mesh = mesh;
  out.bounds = bounds_of(mesh);
  if (mesh.position_mm.empty()) return out;
  out.body = body_mesh(mesh.name);
  Bounds all = out.bounds;
  if (!out.body.position_mm.empty()) {
    const Bounds body = bounds_of(out.body);
    all = {glm::min(all.low, body.low), glm::max(all.high, body.high)};
  }
  // Shipped drapes stand on y = 0; others on their lowest point, with a little air so that a cloth that
  // lies flat does not fight the ground.
  out.ground_mm = out.body.position_mm.empty() ? all.low.y - 0.002f * out.bounds.radius() : std::min(0.0f, all.low.y);
  Voxels voxels(all.low, all.high);
  voxels.fill(out.mesh);
  voxels.fill(out.body);
  out.sky = sky_of(out.mesh, voxels, true);
  out.body_sky = sky_of(out.body, voxels, false);
  fill_ground(out, voxels);
  constexpr size_t kMostTriangles = 400'000;
  out.fine = out.mesh.index.size() <= 3 * kMostTriangles ? out.mesh.index : simplify(out.mesh, 0.0001f);
  out.coarse = simplify(out.mesh, 0.0012f);
  out.body_fine = simplify(out.body, 0.002f);
  return out;
}

}  // namespace weftlight
