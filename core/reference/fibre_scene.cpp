#include "reference/fibre_scene.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "base/loops.h"
#include "base/text.h"
#include "reference/embree.h"
#include "reference/fibre_dye.h"
#include "reference/fibre_plan.h"
#include "reference/thread_curves.h"
#include "reference/tiles.h"

namespace weftlight::reference {

using base::ErrorKind, base::arg, base::failure, base::fill, base::for_each_job, base::tr;
using cloth::FibreDye, cloth::PlyFibre;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// One fibre, hair or loop: from its first piece to the next strand's.
struct Strand {
  uint32_t first_piece = 0;
  uint32_t yarn = 0;
  glm::vec3 dye{0};  // reflectance of its cloth, then the absorption for that; a metallic one has its own reflectance
  float depth = 1;   // of the dye, relative to the cloth's
};

/// Bytes that Embree holds, now and at most.
struct MemoryMeter {
  std::atomic<int64_t> now{0}, most{0};
};

bool meter(void* user, ssize_t bytes, bool) {
  auto* meter = static_cast<MemoryMeter*>(user);
  const int64_t now = meter->now += bytes;
  for (int64_t most = meter->most; now > most && !meter->most.compare_exchange_weak(most, now);) {
  }
  return true;
}

/// The fibres of a thread, and where their points and pieces begin in the buffers.
struct BuiltThread {
  ThreadFibres made;
  size_t first_vertex = 0, first_piece = 0, first_strand = 0;
  size_t vertices = 0, pieces = 0, strands = 0;
};

struct Heights {
  float low = kInfinity, high = -kInfinity;
  void add(float z, float radius) { low = std::min(low, z - radius), high = std::max(high, z + radius); }
  void add(const Heights& other) { low = std::min(low, other.low), high = std::max(high, other.high); }
};

/// An error with the figure if it is more than allowed.
base::Result<void> within(const FibreFigures& figures, int64_t max_bytes) {
  if (figures.bytes <= max_bytes && figures.curves < (int64_t{1} << 31)) return {};
  const auto mb = [](int64_t bytes) { return (bytes + (1 << 20) - 1) >> 20; };
  return failure(ErrorKind::kInput,
                 fill(tr("the fibres of {width} x {height} mm of this cloth need {needed} MB of memory, and {limit} MB "
                         "are allowed; show less of the cloth (a smaller --size or --yarns-per-pixel)"),
                      arg("width", std::round(figures.size_mm.x * 10) / 10),
                      arg("height", std::round(figures.size_mm.y * 10) / 10), arg("needed", mb(figures.bytes)),
                      arg("limit", mb(max_bytes))));
}

}  // namespace

struct FibreScene::Parts {
  ThreadPaths paths;
  FibrePlan plan;
  Tiling tiling;
  float thickness = 0;
  MemoryMeter memory;
  int64_t own_bytes = 0;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  const glm::vec4* vertices = nullptr;  // Embree's buffers
  const uint32_t* indices = nullptr;
  std::vector<Strand> strands;
  std::vector<formulas::FibreOptics> optics;  // by yarn
  std::optional<ThreadReflectance> reflectance;
  ~Parts() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }

  std::vector<BuiltThread> make_threads() const;
  void count(const std::vector<BuiltThread>& threads);
  bool make_scene(const std::vector<BuiltThread>& threads);
  void list_optics();
  Strand strand_of(const PlannedThread& plan, size_t piece, const FibreDye& own) const;
  void dye(const std::vector<DyeCurve>& curves);
  void fill_thread(const BuiltThread& built, glm::vec4* vertices, uint32_t* indices, Heights& core, Heights& all);
  glm::vec3 tangent_at(uint32_t piece, float u) const;
  void read_hit(const RTCRayHit& ray, glm::vec3 position, glm::vec3 direction, FibreHit& hit) const;
};

std::vector<BuiltThread> FibreScene::Parts::make_threads() const {
  std::vector<BuiltThread> all(plan.threads.size());
  for_each_job(static_cast<int>(all.size()), 0, [&](int i) {
    all[static_cast<size_t>(i)].made = thread_fibres(plan, plan.threads[static_cast<size_t>(i)]);
  });
  size_t vertex = 0, piece = 0, strand = 0;
  for (BuiltThread& built : all) {
    built.first_vertex = vertex, built.first_piece = piece, built.first_strand = strand;
    const ThreadFibres& made = built.made;
    const size_t points = static_cast<size_t>(made.plan->points), fibres = made.yarn.fibres.size();
    built.strands = fibres + made.strays.size();
    built.pieces = fibres * (points - 1);
    for (const PlacedStray& stray : made.strays) built.pieces += static_cast<size_t>(pieces_of(stray.fibre));
    built.vertices = built.pieces + built.strands;
    vertex += built.vertices, piece += built.pieces, strand += built.strands;
  }
  return all;
}

void FibreScene::Parts::list_optics() {
  for (const design::Yarn& yarn : paths.cloth().yarns) {
    const design::FibreFacts facts = design::fibre_facts(yarn);
    formulas::FibreOptics o{};
    o.index = std::clamp(yarn.lobes.ior, 1.0f, 3.0f);
    o.along = facts.along_rad, o.across = facts.across_rad;
    o.turbidity = facts.turbidity;
    o.metal = glm::vec3(facts.metallic ? 1.0f : 0.0f);
    optics.push_back(o);
  }
}

Strand FibreScene::Parts::strand_of(const PlannedThread& thread, size_t piece, const FibreDye& own) const {
  const ThreadBody& body = paths.threads(thread.system)[static_cast<size_t>(thread.thread)];
  // A strand has one colour: that of its thread in the middle of the patch.
  const cloth::Linear& dye = colour_along(paths.cloth(), thread.system, thread.thread, plan.middle(thread.system));
  const glm::vec3 colour(dye.r, dye.g, dye.b);
  const bool metallic = optics[static_cast<size_t>(body.yarn)].metal.x > 0;
  return {static_cast<uint32_t>(piece), static_cast<uint32_t>(body.yarn),
          metallic ? own.on_surface(colour) : reflectance->of(thread.system, body.yarn, own.tinted(colour)), own.depth};
}

void FibreScene::Parts::dye(const std::vector<DyeCurve>& curves) {
  for (Strand& strand : strands) {
    if (optics[strand.yarn].metal.x > 0) continue;
    for (int c = 0; c < 3; ++c) strand.dye[c] = strand.depth * curves[strand.yarn].absorption(strand.dye[c]);
  }
}

void FibreScene::Parts::fill_thread(const BuiltThread& built, glm::vec4* vertex, uint32_t* index, Heights& core,
                                    Heights& all) {
  const PlannedThread& thread = *built.made.plan;
  const ThreadCurves curves(paths, plan, built.made);
  vertex += built.first_vertex, index += built.first_piece;
  size_t next_vertex = built.first_vertex, piece = built.first_piece, strand = built.first_strand;
  const auto add = [&](int pieces, const FibreDye& own, Heights& heights) {
    strands[strand++] = strand_of(thread, piece, own);
    for (int k = 0; k < pieces; ++k) *index++ = static_cast<uint32_t>(next_vertex++);
    for (int k = 0; k <= pieces; ++k) heights.add(vertex[k].z, vertex[k].w);
    ++next_vertex, piece += static_cast<size_t>(pieces), vertex += pieces + 1;
  };
  for (const PlyFibre& fibre : built.made.yarn.fibres) {
    curves.fibre(fibre, vertex);
    add(thread.points - 1, fibre.dye, core);
  }
  all.add(core);
  for (const PlacedStray& stray : built.made.strays) {
    curves.stray(stray, vertex);
    add(pieces_of(stray.fibre), stray.fibre.dye, all);
  }
}

/// What is to be allocated, exactly.
void FibreScene::Parts::count(const std::vector<BuiltThread>& threads) {
  FibreFigures& f = plan.figures;
  f.fibres = f.strays = f.curves = 0;
  for (const BuiltThread& t : threads) {
    f.fibres += static_cast<int64_t>(t.made.yarn.fibres.size()), f.strays += static_cast<int64_t>(t.made.strays.size());
    f.curves += static_cast<int64_t>(t.pieces);
  }
  f.bytes = bytes_of(f);
}

bool FibreScene::Parts::make_scene(const std::vector<BuiltThread>& threads) {
  device = rtcNewDevice(nullptr);
  if (!device) return false;
  rtcSetDeviceMemoryMonitorFunction(device, meter, &memory);
  scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_COMPACT);
  list_optics();
  const auto piece_count = static_cast<size_t>(plan.figures.curves),
             strand_count = static_cast<size_t>(plan.figures.fibres + plan.figures.strays);
  const size_t vertex_count = piece_count + strand_count;
  own_bytes = plan.figures.fibres * static_cast<int64_t>(sizeof(PlyFibre)) +
              plan.figures.strays * static_cast<int64_t>(sizeof(PlacedStray));
  if (piece_count == 0) {
    rtcCommitScene(scene);
    return true;
  }
  strands.resize(strand_count);
  own_bytes += static_cast<int64_t>(strand_count * sizeof(Strand));
  RTCGeometry curves = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_FLAT_LINEAR_CURVE);
  auto* v = static_cast<glm::vec4*>(
      rtcSetNewGeometryBuffer(curves, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(glm::vec4), vertex_count));
  auto* i = static_cast<uint32_t*>(
      rtcSetNewGeometryBuffer(curves, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, sizeof(uint32_t), piece_count));
  const bool room = v && i;
  if (room) {
    vertices = v, indices = i;
    std::vector<Heights> core(threads.size()), all(threads.size());
    for_each_job(static_cast<int>(threads.size()), 0, [&](int t) {
      const size_t k = static_cast<size_t>(t);
      fill_thread(threads[k], v, i, core[k], all[k]);
    });
    rtcCommitGeometry(curves);
    rtcAttachGeometry(scene, curves);
    rtcCommitScene(scene);
    for (size_t k = 1; k < threads.size(); ++k) core[0].add(core[k]), all[0].add(all[k]);
    thickness = core[0].high - core[0].low;
    const float pad = 1e-3f * std::max(all[0].high - all[0].low, 1e-4f);
    tiling.z_min = all[0].low - pad, tiling.z_max = all[0].high + pad;
  }
  rtcReleaseGeometry(curves);
  return room;
}

/// Direction of the fibre, smooth from piece to piece.
glm::vec3 FibreScene::Parts::tangent_at(uint32_t piece, float u) const {
  const uint32_t a = indices[piece];
  const glm::vec3 own = glm::vec3(vertices[a + 1]) - glm::vec3(vertices[a]);
  const bool before = piece > 0 && indices[piece - 1] + 1 == a;
  const bool after = piece + 1 < plan.figures.curves && indices[piece + 1] == a + 1;
  glm::vec3 tangent = own;
  if (u < 0.5f && before) tangent = own + (glm::vec3(vertices[a]) - glm::vec3(vertices[a - 1]) - own) * (0.5f - u);
  if (u > 0.5f && after) tangent = own + (glm::vec3(vertices[a + 2]) - glm::vec3(vertices[a + 1]) - own) * (u - 0.5f);
  return glm::normalize(tangent);
}

void FibreScene::Parts::read_hit(const RTCRayHit& ray, glm::vec3 local, glm::vec3 direction, FibreHit& hit) const {
  const uint32_t piece = ray.hit.primID, a = indices[piece];
  const float u = std::clamp(ray.hit.u, 0.0f, 1.0f);
  const glm::vec4 on_axis = glm::mix(vertices[a], vertices[a + 1], u);
  hit.t = ray.ray.tfar;
  hit.axis = tangent_at(piece, u);
  hit.radius_mm = on_axis.w;
  const glm::vec3 from_axis = local + direction * hit.t - glm::vec3(on_axis);
  const glm::vec3 aside = glm::cross(hit.axis, -direction);
  const float length = glm::length(aside);
  hit.offset = length > 1e-6f ? std::clamp(glm::dot(from_axis, aside) / (length * hit.radius_mm), -0.999f, 0.999f) : 0;
  hit.centre =
      local + direction * hit.t - (length > 1e-6f ? aside * (hit.offset * hit.radius_mm / length) : glm::vec3(0));
  const auto strand = std::upper_bound(strands.begin(), strands.end(), piece,
                                       [](uint32_t p, const Strand& s) { return p < s.first_piece; }) -
                      1;
  hit.yarn = strand->yarn;
  hit.optics = optics[strand->yarn];
  hit.depth = strand->depth;
  (hit.optics.metal.x > 0 ? hit.optics.metal : hit.optics.absorption) = strand->dye;
}

base::Result<std::unique_ptr<FibreScene>> FibreScene::build(const Cloth& cloth, const FibreOptions& options) {
  if (cloth.ends.empty() || cloth.picks.empty() || !(cloth.width_mm > 0) || !(cloth.depth_mm > 0))
    return failure(ErrorKind::kInput, tr("the cloth has no size"));
  std::unique_ptr<FibreScene> scene(new FibreScene);
  Parts& parts = *scene->parts_;
  parts.paths = ThreadPaths(cloth);
  parts.plan = plan_fibres(parts.paths, options);
  if (auto room = within(parts.plan.figures, options.max_bytes); !room) return base::failed(room);
  parts.reflectance.emplace(cloth);
  const std::vector<BuiltThread> threads = parts.make_threads();
  parts.count(threads);
  if (auto room = within(parts.plan.figures, options.max_bytes); !room) return base::failed(room);
  parts.paths.compute_lines();
  for (int k = 0; k < 2; ++k)
    if (parts.plan.repeats[k]) parts.tiling.size[k] = parts.plan.high[k];
  if (!parts.make_scene(threads))
    return failure(ErrorKind::kMemory,
                   tr("the ray tracer (Embree) could not be started, or there is not enough memory"));
  parts.dye(measure_dyes(*scene, options.low_mm, options.high_mm));
  return scene;
}

FibreScene::FibreScene() : parts_(std::make_unique<Parts>()) {}
FibreScene::~FibreScene() = default;
const Cloth& FibreScene::cloth() const { return parts_->paths.cloth(); }
const FibreFigures& FibreScene::figures() const { return parts_->plan.figures; }
int64_t FibreScene::peak_bytes() const { return parts_->memory.most + parts_->own_bytes; }
float FibreScene::z_min() const { return parts_->tiling.z_min; }
float FibreScene::z_max() const { return parts_->tiling.z_max; }
float FibreScene::thickness_mm() const { return parts_->thickness; }

bool FibreScene::intersect(glm::vec3 origin, glm::vec3 direction, float t_min, FibreHit& hit) const {
  return walk_tiles(parts_->tiling, origin, direction, t_min, [&](glm::vec3 local, float t_near, float t_far) {
    RTCRayHit ray;
    if (!closest_hit(parts_->scene, ray_between(local, direction, t_near, t_far), ray)) return false;
    parts_->read_hit(ray, local, direction, hit);
    hit.centre += origin - local;
    return true;
  });
}

bool FibreScene::occluded(glm::vec3 origin, glm::vec3 direction, float t_min) const {
  return walk_tiles(parts_->tiling, origin, direction, t_min, [&](glm::vec3 local, float t_near, float t_far) {
    return hits_any(parts_->scene, ray_between(local, direction, t_near, t_far));
  });
}

}  // namespace weftlight::reference
