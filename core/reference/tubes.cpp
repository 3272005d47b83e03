// Tubes as triangles in Embree, with the smooth normal of the swept section at the hit. Rays walk from tile to tile of
// the period, so that the cloth has no edge.

#include "reference/tubes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/text.h"
#include "reference/embree.h"
#include "reference/thread_paths.h"
#include "reference/tiles.h"

namespace weftlight::reference {

using base::ErrorKind, base::arg, base::failure, base::fill, base::tr;
using cloth::thread_formulas::section_gradient;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Tube {
  System system;
  int thread;
  float centre_mm;  // may be a wrapped copy outside the period
  uint32_t first_triangle;
};

}  // namespace

struct TubeScene::Parts {
  ThreadPaths paths;
  int around = 0;
  int rings[2] = {0, 0};  // segments along a tube of each system over the tile
  // Extra segments beyond both ends: sections lean, so what is on top at the edge of the tile may start outside it.
  int beyond[2] = {0, 0};
  glm::vec2 tile{0};  // tile size, whole periods
  float z_min = 0, z_max = 0;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<Tube> tubes;
  ~Parts() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }

  float tile_along(System s) const { return s == System::kWarp ? tile.y : tile.x; }
  float tile_across(System s) const { return s == System::kWarp ? tile.x : tile.y; }
  int segments(System s) const { return rings[static_cast<int>(s)] + 2 * beyond[static_cast<int>(s)]; }
  float step(System s) const { return tile_along(s) / static_cast<float>(rings[static_cast<int>(s)]); }
  float along_of(System s, float ring) const {
    return (ring - static_cast<float>(beyond[static_cast<int>(s)])) * step(s);
  }
  void list_tubes();
  int64_t triangle_count() const;
  size_t vertex_count() const;
  bool choose_resolution(const TubeOptions& options);
  bool make_scene();
  void fill(glm::vec3* vertices, uint32_t* indices);
  void read_hit(const RTCRayHit& ray, TubeHit& hit) const;
  Tiling tiling() const { return {tile, z_min, z_max}; }
};

void TubeScene::Parts::list_tubes() {
  tubes.clear();
  uint32_t triangle = 0;
  for (System s : {System::kWarp, System::kWeft}) {
    const auto& bodies = paths.threads(s);
    const float period = paths.period_across(s), across = tile_across(s);
    const int repeats = static_cast<int>(std::lround(across / period));
    for (int r = -1; r <= repeats; ++r) {
      for (size_t i = 0; i < bodies.size(); ++i) {
        const float centre = bodies[i].centre_mm + static_cast<float>(r) * period;
        const float reach = paths.widest(s, static_cast<int>(i));
        if (centre + reach < 0 || centre - reach > across) continue;
        tubes.push_back({s, static_cast<int>(i), centre, triangle});
        triangle += static_cast<uint32_t>(segments(s) * around * 2);
      }
    }
  }
}

int64_t TubeScene::Parts::triangle_count() const {
  int64_t count = 0;
  for (const Tube& tube : tubes) count += int64_t{2} * segments(tube.system) * around;
  return count;
}

size_t TubeScene::Parts::vertex_count() const {
  size_t count = 0;
  for (const Tube& tube : tubes) count += static_cast<size_t>(segments(tube.system) + 1) * static_cast<size_t>(around);
  return count;
}

bool TubeScene::Parts::choose_resolution(const TubeOptions& options) {
  const Cloth& cloth = paths.cloth();
  const int ends = static_cast<int>(cloth.ends.size()), picks = static_cast<int>(cloth.picks.size());
  // Small repeats are combined into a tile of about 24 threads, for fewer steps from tile to tile.
  const int across = std::max(1, 24 / ends), down = std::max(1, 24 / picks);
  tile = {cloth.width_mm * static_cast<float>(across), cloth.depth_mm * static_cast<float>(down)};
  around = options.around;
  int per_crossing = options.per_crossing;
  for (;;) {
    if (int64_t{8} * ends * picks * per_crossing < options.max_triangles) {
      rings[0] = picks * down * per_crossing;
      rings[1] = ends * across * per_crossing;
      for (const System s : {System::kWarp, System::kWeft}) {
        const int most = rings[static_cast<int>(s)];
        beyond[static_cast<int>(s)] = std::clamp(static_cast<int>(std::ceil(paths.thickest(s) / step(s))), 1, most);
      }
      list_tubes();
      if (triangle_count() <= options.max_triangles) return true;
    }
    if (around <= 8 && per_crossing <= 4) return false;
    around = std::max(8, around * 3 / 4);
    per_crossing = std::max(4, per_crossing * 3 / 4);
  }
}

void TubeScene::Parts::fill(glm::vec3* vertices, uint32_t* indices) {
  uint32_t vertex = 0;
  z_min = kInfinity;
  z_max = -kInfinity;
  const uint32_t n = static_cast<uint32_t>(around);
  for (const Tube& tube : tubes) {
    const System s = tube.system;
    for (int i = 0; i <= segments(s); ++i) {
      const ThreadRing ring = paths.ring_at(s, tube.thread, along_of(s, static_cast<float>(i)));
      const glm::vec3 centre = centre_of(s, tube.centre_mm, ring), across = across_of(s), up = up_of(s, ring.slope);
      for (int k = 0; k < around; ++k) {
        const float a = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / static_cast<float>(around);
        const glm::vec2 edge = ring.radii * section_edge(ring, a);
        const glm::vec3 p = centre + across * edge.x + up * edge.y;
        z_min = std::min(z_min, p.z);
        z_max = std::max(z_max, p.z);
        *vertices++ = p;
      }
    }
    for (uint32_t i = 0; i < static_cast<uint32_t>(segments(s)); ++i) {
      for (uint32_t k = 0; k < n; ++k) {
        const uint32_t a = vertex + i * n + k, b = vertex + i * n + (k + 1) % n, c = a + n, d = b + n;
        for (uint32_t corner : {a, b, c, b, d, c}) *indices++ = corner;
      }
    }
    vertex += static_cast<uint32_t>(segments(s) + 1) * n;
  }
  // Rays start at these planes, so the highest ridge must lie clearly below.
  const float pad = 1e-3f * std::max(z_max - z_min, 1e-4f);
  z_min -= pad;
  z_max += pad;
}

bool TubeScene::Parts::make_scene() {
  device = rtcNewDevice(nullptr);
  if (!device) return false;
  scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<glm::vec3*>(
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), vertex_count()));
  auto* indices = static_cast<uint32_t*>(rtcSetNewGeometryBuffer(
      mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), static_cast<size_t>(triangle_count())));
  const bool room = vertices && indices;
  if (room) {
    fill(vertices, indices);
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene, mesh);
    rtcCommitScene(scene);
  }
  rtcReleaseGeometry(mesh);
  return room;
}

void TubeScene::Parts::read_hit(const RTCRayHit& ray, TubeHit& hit) const {
  const uint32_t prim = ray.hit.primID;
  const auto tube = std::upper_bound(tubes.begin(), tubes.end(), prim,
                                     [](uint32_t p, const Tube& t) { return p < t.first_triangle; }) -
                    1;
  const uint32_t quad = (prim - tube->first_triangle) / 2;
  const bool second = (prim - tube->first_triangle) & 1;
  const float ring = static_cast<float>(quad / static_cast<uint32_t>(around));
  const float facet = static_cast<float>(quad % static_cast<uint32_t>(around));
  // Triangle (a, b, c): u towards b (around), v towards c (along). Triangle (b, d, c): from b, u to d, v to c.
  const float u = ray.hit.u, v = ray.hit.v;
  const float around_part = second ? 1 - v : u;
  const float along_part = second ? u + v : v;
  const System s = tube->system;
  const float along = along_of(s, ring + along_part);
  hit.system = s;
  hit.thread = tube->thread;
  hit.around_rad = 2 * std::numbers::pi_v<float> * (facet + around_part) / static_cast<float>(around);
  hit.along_mm = along - std::floor(along / paths.period_along(s)) * paths.period_along(s);
  const ThreadRing at = paths.ring_at(s, tube->thread, along);
  hit.axis = axis_of(s, at.slope, at.sideways);
  const glm::vec2 edge = section_edge(at, hit.around_rad),
                  gradient = section_gradient(edge.x, edge.y, at.squareness) / at.radii;
  const glm::vec3 out = across_of(s) * gradient.x + up_of(s, at.slope) * gradient.y;
  hit.normal = glm::normalize(out - hit.axis * glm::dot(out, hit.axis));
}

base::Result<std::unique_ptr<TubeScene>> TubeScene::build(const Cloth& cloth, const TubeOptions& options) {
  std::unique_ptr<TubeScene> scene(new TubeScene);
  Parts& parts = *scene->parts_;
  if (cloth.ends.empty() || cloth.picks.empty() || !(cloth.width_mm > 0) || !(cloth.depth_mm > 0))
    return failure(ErrorKind::kInput, tr("the cloth has no size"));
  parts.paths = ThreadPaths(cloth);
  if (!parts.choose_resolution(options))
    return failure(
        ErrorKind::kInput,
        fill(tr("a repeat of {ends} ends and {picks} picks is too large to trace thread by thread; use `render`, or "
                "trace a smaller draft"),
             arg("ends", cloth.ends.size()), arg("picks", cloth.picks.size())));
  parts.paths.compute_lines();
  if (!parts.make_scene())
    return failure(ErrorKind::kMemory,
                   tr("the ray tracer (Embree) could not be started, or there is not enough memory"));
  return scene;
}

TubeScene::TubeScene() : parts_(std::make_unique<Parts>()) {}
TubeScene::~TubeScene() = default;
float TubeScene::z_min() const { return parts_->z_min; }
float TubeScene::z_max() const { return parts_->z_max; }
const Cloth& TubeScene::cloth() const { return parts_->paths.cloth(); }

bool TubeScene::intersect(glm::vec3 origin, glm::vec3 direction, float t_min, TubeHit& hit) const {
  return walk_tiles(parts_->tiling(), origin, direction, t_min, [&](glm::vec3 local, float t_near, float t_far) {
    RTCRayHit ray;
    if (!closest_hit(parts_->scene, ray_between(local, direction, t_near, t_far), ray)) return false;
    hit.t = ray.ray.tfar;
    hit.position = origin + direction * hit.t;
    parts_->read_hit(ray, hit);
    return true;
  });
}

bool TubeScene::occluded(glm::vec3 origin, glm::vec3 direction, float t_min) const {
  return walk_tiles(parts_->tiling(), origin, direction, t_min, [&](glm::vec3 local, float t_near, float t_far) {
    return hits_any(parts_->scene, ray_between(local, direction, t_near, t_far));
  });
}

}  // namespace weftlight::reference
