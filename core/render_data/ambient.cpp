#include "render_data/ambient.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "base/loops.h"
#include "reference/mesh_scene.h"

namespace weftlight::render_data {

using base::for_each_job;
using drape::Vec3, drape::body_mesh;
using reference::MeshScene;
using scene::bounds_of;

namespace {

constexpr int kDirections = 64, kFewDirections = 16,
              kFirstDirections = 6;  // a vertex; for meshes of many vertices; for a first picture
constexpr size_t kManyVertices = 100'000;
constexpr int kGroundSize = 96;
constexpr float kGroundReach = 2.2f;  // half width of the ground's map in bounding radii

/// Occluders of the sky: cloth and body. None without a ray tracer.
class Occluders {
 public:
  Occluders(const Mesh& cloth, const Mesh& body, float lift_mm) : lift_mm_(lift_mm) {
    for (const Mesh* mesh : {&cloth, &body}) {
      if (auto scene = MeshScene::build(*mesh)) scenes_.push_back(std::move(*scene));
    }
  }
  /// Fraction of the cosine-weighted sky about n.
  float sky_visibility(glm::vec3 p, glm::vec3 n, const std::vector<glm::vec3>& directions) const {
    const glm::vec3 helper = std::abs(n.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 t = glm::normalize(glm::cross(helper, n)), b = glm::cross(n, t), from = p + n * lift_mm_;
    int open = 0;
    for (const glm::vec3& d : directions) {
      const glm::vec3 along = t * d.x + b * d.y + n * d.z;
      open += std::none_of(scenes_.begin(), scenes_.end(),
                           [&](const auto& scene) { return scene->occluded(from, along, lift_mm_); });
    }
    return static_cast<float>(open) / static_cast<float>(directions.size());
  }

 private:
  std::vector<std::unique_ptr<MeshScene>> scenes_;
  float lift_mm_;  // ray offset over the flat triangles of a curved surface
};

/// Directions about +z, cosine-weighted (a Fibonacci spiral on the disc).
std::vector<glm::vec3> cosine_directions(int count) {
  std::vector<glm::vec3> d;
  for (int i = 0; i < count; ++i) {
    const float r2 = (static_cast<float>(i) + 0.5f) / static_cast<float>(count), r = std::sqrt(r2);
    const float a = 2.39996323f * static_cast<float>(i);
    d.push_back({r * std::cos(a), r * std::sin(a), std::sqrt(1 - r2)});
  }
  return d;
}

/// Averages over neighbours, to hide the noise of the few directions.
void smooth(std::vector<SkyVisibility>& sky, const Mesh& mesh) {
  for (int pass = 0; pass < 2; ++pass) {
    std::vector<SkyVisibility> sum(sky.size(), SkyVisibility{0, 0});
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

std::vector<SkyVisibility> sky_of(const Mesh& mesh, const Occluders& occluders, bool both_sides, SkyRays rays) {
  const size_t vertices = mesh.position_mm.size();
  const int at_rest = vertices <= kManyVertices ? kDirections : kFewDirections;
  const std::vector<glm::vec3> directions = cosine_directions(rays == SkyRays::kFew ? kFirstDirections : at_rest);
  std::vector<SkyVisibility> sky(vertices);
  for_each_job(static_cast<int>(vertices), [&](int i) {
    const size_t v = static_cast<size_t>(i);
    const glm::vec3 p = mesh.position_mm[v], n = mesh.normal[v];
    sky[v].front = occluders.sky_visibility(p, n, directions);
    sky[v].back = both_sides ? occluders.sky_visibility(p, -n, directions) : 1.0f;
  });
  smooth(sky, mesh);
  return sky;
}

void fill_ground(PreparedMesh& out, const Occluders& occluders, SkyRays rays) {
  const std::vector<glm::vec3> directions = cosine_directions(rays == SkyRays::kFew ? kFirstDirections : kDirections);
  out.ground_size = kGroundSize;
  out.ground_half_mm = out.bounds.radius() * kGroundReach;
  out.ground_sky.resize(static_cast<size_t>(kGroundSize) * kGroundSize);
  const glm::vec3 c = out.bounds.centre();
  for_each_job(kGroundSize * kGroundSize, [&](int i) {
    const auto across = [](int k) { return (static_cast<float>(k) + 0.5f) / kGroundSize * 2 - 1; };
    const glm::vec3 p{c.x + across(i % kGroundSize) * out.ground_half_mm, out.ground_mm,
                      c.z + across(i / kGroundSize) * out.ground_half_mm};
    out.ground_sky[static_cast<size_t>(i)] =
        static_cast<uint8_t>(occluders.sky_visibility(p, glm::vec3(0, 1, 0), directions) * 255 + 0.5f);
  });
}

/// Simplifies to fewer triangles over the same vertices, with at most `error` of the mesh's extent; the texture moves
/// by as much, which is more than a yarn on a table.
std::vector<uint32_t> simplify(const Mesh& mesh, float error) {
  if (mesh.index.empty()) return {};
  std::vector<uint32_t> index(mesh.index.size());
  const size_t count = meshopt_simplify(index.data(), mesh.index.data(), mesh.index.size(), &mesh.position_mm[0].x,
                                        mesh.position_mm.size(), sizeof(Vec3), mesh.index.size() / 16, error);
  index.resize(count);
  return index;
}

}  // namespace

Mesh form_under(const std::string& drape, const Bounds& cloth) {
  constexpr float kThinner = 0.005f;  // of the cloth's radius
  Mesh form = body_mesh(drape);
  const float thinner = kThinner * cloth.radius();
  for (size_t i = 0; i < form.position_mm.size(); ++i)
    for (size_t k = 0; k < 3; ++k) form.position_mm[i][k] -= thinner * form.normal[i][k];
  return form;
}

PreparedMesh prepare_mesh(const Mesh& mesh, SkyRays rays) {
  PreparedMesh out;
  out.mesh = mesh;
  out.bounds = bounds_of(mesh);
  if (mesh.position_mm.empty()) return out;
  out.body = form_under(mesh.name, out.bounds);
  Bounds all = out.bounds;
  if (!out.body.position_mm.empty()) {
    const Bounds body = bounds_of(out.body);
    all = {glm::min(all.low, body.low), glm::max(all.high, body.high)};
  }
  // Shipped drapes stand on y = 0, others on their lowest point, with a small gap so that a flat cloth does not
  // z-fight the ground.
  out.ground_mm = out.body.position_mm.empty() ? all.low.y - 0.002f * out.bounds.radius() : std::min(0.0f, all.low.y);
  const Occluders occluders(out.mesh, out.body, 0.002f * out.bounds.radius());
  out.sky = sky_of(out.mesh, occluders, true, rays);
  out.body_sky = sky_of(out.body, occluders, false, rays);
  fill_ground(out, occluders, rays);
  constexpr size_t kMaxTriangles = 400'000;
  out.fine = out.mesh.index.size() <= 3 * kMaxTriangles ? out.mesh.index : simplify(out.mesh, 0.0001f);
  out.coarse = simplify(out.mesh, 0.0012f);
  out.body_fine = simplify(out.body, 0.002f);
  return out;
}

}  // namespace weftlight::render_data
