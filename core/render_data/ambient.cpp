#include "render_data/ambient.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/loops.h"
#include "reference/mesh_scene.h"
#include "shaders/interop.h"

namespace weftlight::render_data {

using base::for_each_job;
using drape::Vec3, drape::body_mesh, drape::turn_diagonals;
using reference::MeshHit, reference::MeshScene;
using scene::bounds_of;

namespace {

constexpr int kDirections = 64, kFewDirections = 16,
              kFirstDirections = 6;  // a vertex; for meshes of many vertices; for a first picture
constexpr size_t kManyVertices = 100'000;
constexpr int kGroundSize = 96;
constexpr float kClothSends = 0.2f;   // to the body under it: what cloth of a middle tone reflects
constexpr float kGroundReach = 2.2f;  // half width of the ground's map in bounding radii

/// A mesh that hides the sky, and sends on what its own vertices see of it.
class Occluder {
 public:
  Occluder(const Mesh& mesh, float reflectance)
      : mesh_(mesh), scene_(MeshScene::build(mesh).value_or(nullptr)), reflectance_(reflectance) {}
  /// Of each vertex; kept by the caller. Until then nothing is sent on.
  void use_sky(const std::vector<SkyVisibility>& sky) { sky_ = &sky; }
  bool sends() const { return sky_ != nullptr; }
  bool sends_to(glm::vec3 from, glm::vec3 along, float t_min) const { return sends() && hides(from, along, t_min); }
  bool hides(glm::vec3 from, glm::vec3 along, float t_min, float t_max = MeshScene::kEndless) const {
    return scene_ && scene_->occluded(from, along, t_min, t_max);
  }
  bool hit_by(glm::vec3 from, glm::vec3 along, float t_min, MeshHit& hit) const {
    return scene_ && scene_->intersect(from, along, t_min, hit);
  }
  float sent_from(const MeshHit& hit) const {
    const uint32_t* corner = &mesh_.index[size_t{3} * hit.triangle];
    const auto side = hit.front ? &SkyVisibility::front : &SkyVisibility::back;
    return reflectance_ * ((*sky_)[corner[0]].*side + (*sky_)[corner[1]].*side + (*sky_)[corner[2]].*side) / 3;
  }

 private:
  const Mesh& mesh_;
  std::unique_ptr<MeshScene> scene_;
  float reflectance_;
  const std::vector<SkyVisibility>* sky_ = nullptr;
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

/// Cloth and body. None without a ray tracer.
class Occluders {
 public:
  Occluders(const Mesh& cloth, const Mesh& body, float lift_mm)
      : cloth_(cloth, kClothSends), body_(body, mean_of(form_reflectance())), lift_mm_(lift_mm) {}
  Occluder& cloth() { return cloth_; }
  Occluder& body() { return body_; }
  /// Fraction of the cosine-weighted sky about n, with what the body sends on.
  float sky_visibility(glm::vec3 p, glm::vec3 n, const std::vector<glm::vec3>& directions) const {
    const glm::vec3 helper = std::abs(n.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 t = glm::normalize(glm::cross(helper, n)), b = glm::cross(n, t), from = p + n * lift_mm_;
    // Light that is sent on is looked for only where one of them is right in front, and by fewer rays: it is dim there,
    // and the closest hit costs more than any.
    const bool faced = body_.sends_to(from, n, lift_mm_) || cloth_.sends_to(from, n, lift_mm_);
    const std::vector<glm::vec3>& used = faced && faced_.size() < directions.size() ? faced_ : directions;
    float open = 0;
    for (const glm::vec3& d : used) {
      const glm::vec3 along = t * d.x + b * d.y + n * d.z;
      open += faced ? light_along(from, along) : hidden(from, along) ? 0.0f : 1.0f;
    }
    return open / static_cast<float>(used.size());
  }

 private:
  static float mean_of(glm::vec3 c) { return (c.r + c.g + c.b) / 3; }
  bool hidden(glm::vec3 from, glm::vec3 along) const {
    return cloth_.hides(from, along, lift_mm_) || body_.hides(from, along, lift_mm_);
  }
  float light_along(glm::vec3 from, glm::vec3 along) const {
    MeshHit on_body, on_cloth;
    const bool body = body_.hit_by(from, along, lift_mm_, on_body);
    if (cloth_.hides(from, along, lift_mm_, body ? on_body.t : MeshScene::kEndless))
      return cloth_.sends() && cloth_.hit_by(from, along, lift_mm_, on_cloth) ? cloth_.sent_from(on_cloth) : 0.0f;
    if (!body) return 1;
    return body_.sends() ? body_.sent_from(on_body) : 0.0f;
  }

  Occluder cloth_, body_;
  std::vector<glm::vec3> faced_ = cosine_directions(kFewDirections);
  float lift_mm_;  // ray offset over the flat triangles of a curved surface
};

/// The places of a surface: both sides of a seam are one, vertices with the same position and normal.
struct Places {
  std::vector<size_t> of;  // each vertex
  size_t count = 0;
};

Places places_of(const Mesh& mesh) {
  using Place = std::pair<Vec3, Vec3>;
  const auto before = [](const Place& a, const Place& b) {
    const drape::PositionOrder less;
    return less(a.first, b.first) || (!less(b.first, a.first) && less(a.second, b.second));
  };
  std::map<Place, size_t, decltype(before)> numbers(before);
  Places places;
  for (size_t i = 0; i < mesh.position_mm.size(); ++i)
    places.of.push_back(numbers.emplace(Place(mesh.position_mm[i], mesh.normal[i]), numbers.size()).first->second);
  places.count = numbers.size();
  return places;
}

/// Averages over neighbours, to hide the noise of the few directions; across seams, which would be lines otherwise.
void smooth(std::vector<SkyVisibility>& sky, const Mesh& mesh) {
  const Places places = places_of(mesh);
  for (int pass = 0; pass < 2; ++pass) {
    std::vector<SkyVisibility> sum(places.count, SkyVisibility{0, 0});
    std::vector<float> count(places.count, 0);
    for (size_t i = 0; i + 2 < mesh.index.size(); i += 3) {
      for (size_t a = 0; a < 3; ++a) {
        for (size_t b = 0; b < 3; ++b) {
          const size_t to = places.of[mesh.index[i + a]];
          const SkyVisibility& from = sky[mesh.index[i + b]];
          sum[to].front += from.front, sum[to].back += from.back, count[to] += 1;
        }
      }
    }
    for (size_t v = 0; v < sky.size(); ++v) {
      const size_t at = places.of[v];
      if (count[at] > 0) sky[v] = {sum[at].front / count[at], sum[at].back / count[at]};
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

/// Values of a mesh's vertices, spread to as many rings of neighbours as there are `rings`, and then evened over as
/// many: where they are largest they stay, and around them they fade. Vertices at one place have one value.
std::vector<float> faded(const Mesh& mesh, const std::vector<float>& values, int rings) {
  const Places places = places_of(mesh);
  const std::vector<size_t>& place = places.of;
  std::vector<float> now(places.count, -std::numeric_limits<float>::max());
  for (size_t i = 0; i < values.size(); ++i) now[place[i]] = std::max(now[place[i]], values[i]);
  const auto for_each_edge = [&](const auto& use) {
    for (size_t t = 0; t < mesh.index.size(); ++t)
      use(place[mesh.index[t]], place[mesh.index[t % 3 == 2 ? t - 2 : t + 1]]);
  };
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<float> largest = now;
    for_each_edge([&](size_t a, size_t b) {
      largest[a] = std::max(largest[a], now[b]), largest[b] = std::max(largest[b], now[a]);
    });
    now = std::move(largest);
  }
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<float> sum = now, count(now.size(), 1.0f);
    for_each_edge([&](size_t a, size_t b) { sum[a] += now[b], sum[b] += now[a], ++count[a], ++count[b]; });
    for (size_t i = 0; i < now.size(); ++i) now[i] = sum[i] / count[i];
  }
  std::vector<float> out(values.size());
  for (size_t i = 0; i < out.size(); ++i) out[i] = now[place[i]];
  return out;
}

}  // namespace

glm::vec3 form_reflectance() {
  using glm::vec3;
  return FORM_REFLECTANCE;
}

Mesh form_under(const std::string& drape, const Mesh& cloth) {
  // Of the cloth's radius: how much thinner, how far off the cloth lies, how far below its upper edge the form fills
  // it, so that nobody looks down between the two, and how far off cloth may hang above what is not that edge.
  constexpr float kThinner = 0.005f, kOver = 0.02f, kFilled = 0.03f, kAbove = 0.1f;
  constexpr int kFadingRings = 6;  // sheer cloth shows the form's outline, where a step would be a row of teeth
  Mesh form = body_mesh(drape);
  const float radius = bounds_of(cloth).radius(), thinner = kThinner * radius;
  const Occluder over(cloth, 0), whole(form, 0);
  std::vector<float> inwards(form.position_mm.size(), 0.0f), outwards = inwards;
  for (size_t i = 0; i < inwards.size(); ++i) {
    const glm::vec3 normal = form.normal[i], at = glm::vec3(form.position_mm[i]) - thinner * normal;
    const auto covered = [&](glm::vec3 p, float within, MeshHit& hit) {
      return over.hit_by(p, normal, 0, hit) && hit.t < within * radius;
    };
    MeshHit hit, above;
    if (!covered(at, kOver, hit)) continue;
    // The rings of a curtain are no thicker than that: they would turn inside out.
    if (whole.hides(form.position_mm[i], -normal, 0.1f * thinner, 2 * thinner)) continue;
    inwards[i] = thinner;
    const bool at_edge = !covered(at + glm::vec3(0, kFilled * radius, 0), kAbove, above);
    if (at_edge) outwards[i] = std::max(hit.t - thinner, 0.0f);
  }
  inwards = faded(form, inwards, kFadingRings);
  for (size_t i = 0; i < inwards.size(); ++i) form.position_mm[i] += form.normal[i] * (outwards[i] - inwards[i]);
  return form;
}

PreparedMesh prepare_mesh(const Mesh& mesh, SkyRays rays) {
  PreparedMesh out;
  out.mesh = mesh;
  out.bounds = bounds_of(mesh);
  if (mesh.position_mm.empty()) return out;
  turn_diagonals(out.mesh);
  out.body = form_under(mesh.name, out.mesh);
  Bounds all = out.bounds;
  if (!out.body.position_mm.empty()) {
    const Bounds body = bounds_of(out.body);
    all = {glm::min(all.low, body.low), glm::max(all.high, body.high)};
  }
  // Shipped drapes stand on y = 0, others on their lowest point, with a small gap so that a flat cloth does not
  // z-fight the ground.
  out.ground_mm = out.body.position_mm.empty() ? all.low.y - 0.002f * out.bounds.radius() : std::min(0.0f, all.low.y);
  Occluders occluders(out.mesh, out.body, 0.002f * out.bounds.radius());
  fill_ground(out, occluders, rays);
  // What is sent on is a mean over many vertices, for which few rays do.
  const std::vector<SkyVisibility> body_sky = sky_of(out.body, occluders, false, SkyRays::kFew);
  if (!out.body.position_mm.empty()) occluders.body().use_sky(body_sky);
  out.sky = sky_of(out.mesh, occluders, true, rays);
  occluders.cloth().use_sky(out.sky);
  out.body_sky = rays == SkyRays::kFew ? body_sky : sky_of(out.body, occluders, false, rays);
  constexpr size_t kMaxTriangles = 400'000;
  out.fine = out.mesh.index.size() <= 3 * kMaxTriangles ? out.mesh.index : simplify(out.mesh, 0.0001f);
  out.coarse = simplify(out.mesh, 0.0012f);
  out.body_fine = simplify(out.body, 0.0003f);  // with three times as much its highlights are wavy
  return out;
}

}  // namespace weftlight::render_data
