// Based on: Roberts 2018 (R2 and R3, even spreads of points in two and three dimensions).

#include "light/thread_samples.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/loops.h"
#include "cloth/centre_step.h"
#include "cloth/thread_scene.h"
#include "light/thread_shadows.h"
#include "light/yarn_lobes.h"

namespace weftlight::light {

namespace thread_formulas = cloth::thread_formulas;

using base::for_each_job;
using cloth::Texel, cloth::ThreadBody, cloth::ThreadScene, cloth::ThreadTexture, cloth::texture_at,
    cloth::thread_textures;
using design::Lobes;
using draft::BitMatrix;

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kWindow = 64, kWindows = 4;  // threads a side of a window, and windows a side
constexpr int kMaxGridCells = 48;          // crossings along a ray
constexpr int kAbove = 1 << 13;            // samples visible from above
// Distribution of angles around a thread, denser at its ridge: the underside is hardly visible.
constexpr float kEvenTurns = 0.55f;

constexpr size_t kHighest = (kResponseElevations - 1) * kViewAzimuths;  // first view from straight above
constexpr size_t kAlong =                                               // from here on lights from behind reach nothing
    (kTransmissionElevations - 1) * kTransmissionAzimuths;  // from there on lights from behind reach nothing

/// Coordinate 0..1 of point k of a low-discrepancy sequence.
float part(int k, double step) { return static_cast<float>(std::fmod(step * (k + 1), 1.0)); }

std::vector<Cloth> windows_of(const Cloth& cloth) {
  const int ends = static_cast<int>(cloth.ends.size()), picks = static_cast<int>(cloth.picks.size());
  std::vector<Cloth> out;
  for (int j = 0; j < kWindows; ++j) {
    for (int i = 0; i < kWindows; ++i) {
      const int wide = std::min(kWindow, ends), high = std::min(kWindow, picks);
      const int e = (ends - wide) * i / (kWindows - 1), p = (picks - high) * j / (kWindows - 1);
      out.push_back(cut(cloth, {e, e + wide, p, p + high}));
    }
  }
  return out;
}

static_assert(std::max<size_t>(kHighest - kLowViews, kAlong) / Directions::kGroup < Directions::kMostGroups);

/// Directions of a grid, from the first to before the last: those of a group are next to each other.
template <size_t kCount>
Directions in_patches(const std::array<glm::vec3, kCount>& grid, size_t azimuths, size_t first, size_t last) {
  constexpr size_t kWide = 4, kHigh = 2;
  Directions out;
  for (size_t row = first; row < last; row += kHigh * azimuths)
    for (size_t a = 0; a < azimuths; a += kWide)
      for (size_t at = row + a; at < std::min(row + kHigh * azimuths, last); at += azimuths)
        for (size_t i = at; i < at + kWide; ++i) out.add(grid[i], i);
  return out;
}

/// Samples one cloth.
class ThreadSampler {
 public:
  explicit ThreadSampler(const Cloth& cloth)
      : cloth_(cloth),
        scene_(cloth),
        shadows_(scene_),
        grid_(scene_.grid()),
        textures_(thread_textures(cloth)),
        views_(response_views()) {
    high_views_ = in_patches(views_, kViewAzimuths, kLowViews, kHighest);
    high_views_.add(views_[kHighest], kHighest), high_views_.finish_group();
    lights_ = in_patches(transmission_lights(), kTransmissionAzimuths, 0, kAlong);
    for (int i = 0; i < grid_.layers; ++i) layers_.push_back(scene_.thread_layer(i, 1));
  }
  /// Sample k of `count` of a system; area 0 if there is none. lit: for light from behind; samples that none reaches
  /// keep only the view from above.
  ThreadSample sample(int system, int k, int count, bool lit);
  void add_top_samples(int first, int count, ThreadSamples& out);

 private:
  float length(int system) const { return system == 0 ? cloth_.depth_mm : cloth_.width_mm; }
  float warp_around(int layer, int end, int pick) const;
  /// What washing adds to the room of a thread.
  float more_room(int system, int thread, float along) const;
  glm::vec3 ply_normal_of(int system, int thread, const thread_formulas::ThreadScene::ThreadPoint& point, Texel& texel);
  void set_shading(ThreadSample& p, int thread, const thread_formulas::ThreadScene::ThreadPoint& point, float step);
  glm::vec3 bend_variance(const thread_formulas::ThreadScene::ThreadPoint& point, float fibre_tan, float step) const;
  // Views from straight above only; all but the lowest; all.
  enum class ViewSet { kTopAlone, kHigh, kLow };
  void find_visible_views(ThreadSample& p, glm::vec3 at, int thread, ViewSet from);
  void find_transmission(ThreadSample& p, glm::vec3 at, int thread);

  const Cloth& cloth_;
  ThreadScene scene_;
  ThreadShadows shadows_;
  thread_formulas::ThreadScene::ThreadGrid grid_;
  std::vector<thread_formulas::ThreadScene::ThreadGrid> layers_;
  std::array<std::vector<ThreadTexture>, 2> textures_;
  std::array<glm::vec3, kResponseViews> views_;
  Directions high_views_, lights_;  // behind
};

/// The warp's fraction of the crossings around one, by a tent filter: like a mip level of four yarns, interpolated
/// between texels.
float ThreadSampler::warp_around(int layer, int end, int pick) const {
  constexpr int kReach = 4, kTop = kReach + 1;
  const auto& grid = layers_[static_cast<size_t>(layer)];
  const int ends = grid.count.x, picks = grid.count.y;
  end -= grid.first.x, pick -= grid.first.y;
  int sum = 0;
  for (int j = -kReach; j <= kReach; ++j) {
    const int row = grid.first.y + (pick + picks * kReach + j) % picks;
    int along = 0;
    for (int i = -kReach; i <= kReach; ++i)
      along += (kTop - std::abs(i)) * cloth_.up.get(row, grid.first.x + (end + ends * kReach + i) % ends);
    sum += (kTop - std::abs(j)) * along;
  }
  return static_cast<float>(sum) / (kTop * kTop * kTop * kTop);
}

float ThreadSampler::more_room(int system, int thread, float along) const {
  if (cloth_.warp_aside_mm.empty()) return 0;
  const draft::System of = system == 0 ? draft::System::kWarp : draft::System::kWeft;
  const cloth::CentreStep step = cloth::centre_step(cloth_, of, thread, along);
  const auto at = [&](int crossing) {
    return 0.5f *
           (cloth::aside_at(cloth_, of, thread + 1, crossing) - cloth::aside_at(cloth_, of, thread - 1, crossing));
  };
  return at(step.crossing) + (at(step.crossing + 1) - at(step.crossing)) * step.t;
}

ThreadSample ThreadSampler::sample(int system, int k, int count, bool lit) {
  const glm::vec2 at = glm::vec2(part(k, 0.8191725133961645), part(k, 0.6710436067037893)) * grid_.period;
  const float u = 2 * part(k, 0.5497004779019703) - 1;
  const float turn = kPi * u * (kEvenTurns + (1 - kEvenTurns) * u * u),
              density = kPi * (kEvenTurns + 3 * (1 - kEvenTurns) * u * u);
  const int layer = k % grid_.layers;
  const auto crossing = scene_.crossing_near(layers_[static_cast<size_t>(layer)], at);
  const auto& s = system == 0 ? crossing.warp : crossing.weft;
  const float along = system == 0 ? at.y : at.x;
  const glm::vec3 c = scene_.strand_curve(s, along);
  const glm::vec4 point = cloth::thread_formulas::section_point(turn, s.squareness);
  const float stretch = std::sqrt(1 + c.y * c.y), x = point.x, y = point.y;
  const glm::vec2 half = 1.0f / scene_.strand_thin(s, along);
  const float around = glm::length(half * glm::vec2(point.z, point.w));
  // Sections are perpendicular to the bent centre line, so they are further apart on the outside of the bend.
  const float apart = stretch * (1 - half.y * y * c.z / (stretch * stretch * stretch));
  const ThreadBody& body = (system == 0 ? cloth_.ends : cloth_.picks)[static_cast<size_t>(s.thread)];
  // A thread fills the same part of its room everywhere.
  const float room = (body.width_mm > 0 ? room_mm(body) * half.x / (0.5f * body.width_mm) : body.spacing_mm) +
                     more_room(system, s.thread, along);
  ThreadSample p;
  p.system = system;
  if (apart <= 0 || room <= 0) return p;
  p.area = around * apart * density * 2 * static_cast<float>(grid_.layers) / (room * static_cast<float>(count));
  const float aside = scene_.strand_centre(s, along) + half.x * x, level = c.x + half.y * y / stretch;
  const float ahead = along - half.y * y * c.y / stretch;
  const glm::vec3 where = system == 0 ? glm::vec3(aside, ahead, level) : glm::vec3(ahead, aside, level);
  p.height_mm = level;
  // Inside the other thread, where both are pressed together.
  if (scene_.strand_distance(system == 0 ? crossing.weft : crossing.warp, system == 0 ? where.y : where.x,
                             system == 0 ? where.x : where.y, where.z) < 0) {
    p.area = 0;
    return p;
  }
  const float warp = warp_around(layer, crossing.warp.thread, crossing.weft.thread);
  p.around = system == 0 ? warp : 1 - warp;
  set_shading(p, s.thread, scene_.thread_point(system, s, where), 1 / std::sqrt(static_cast<float>(count)));
  if (lit) find_transmission(p, where, s.thread);
  find_visible_views(p, where, s.thread, !lit ? ViewSet::kLow : p.lights.empty() ? ViewSet::kTopAlone : ViewSet::kHigh);
  return p;
}

/// Normal with the relief of plies, and the pattern there, with the fibres at their mean.
glm::vec3 ThreadSampler::ply_normal_of(int system, int thread, const thread_formulas::ThreadScene::ThreadPoint& point,
                                       Texel& texel) {
  const ThreadTexture& t = textures_[static_cast<size_t>(system)][static_cast<size_t>(thread)];
  const float fraction = point.along / length(system);
  texel = texture_at(t, thread_formulas::texture_point(t, fraction - std::floor(fraction), point.turn, 1, 1));
  return t.plies > 1 ? scene_.ply_normal(point, t, texel.ply, length(system)) : point.normal;
}

/// Variances of the slopes, along the thread, of the surface that a sample represents, as the lobes hold them: along
/// the fibre, mixed, across it. Otherwise a narrow highlight on a bend would fall on few samples, or on none. step:
/// between samples, over a repeat.
glm::vec3 ThreadSampler::bend_variance(const thread_formulas::ThreadScene::ThreadPoint& point, float fibre_tan,
                                       float step) const {
  constexpr float kRepeat = 8;  // crossings
  constexpr float kMax = 0.04f;
  const float turned = point.bend.x * kRepeat * grid_.spacing * step, tan2 = fibre_tan * fibre_tan;
  // Samples are not on a grid, so neighbours overlap: twice the variance of a box.
  return std::min(turned * turned / 6, kMax) / (1 + tan2) * glm::vec3(1, -fibre_tan, tan2);
}

/// Normals, fibre and lobes, as in core/reference/trace.cpp.
void ThreadSampler::set_shading(ThreadSample& p, int thread, const thread_formulas::ThreadScene::ThreadPoint& point,
                                float step) {
  Texel texel;
  p.side = point.normal;
  p.normal = ply_normal_of(p.system, thread, point, texel);
  p.fibre = point.axis + point.around * textures_[static_cast<size_t>(p.system)][static_cast<size_t>(thread)].fibre_tan;
  p.groove = texel.groove;
  const ThreadBody& body = (p.system == 0 ? cloth_.ends : cloth_.picks)[static_cast<size_t>(thread)];
  const cloth::Linear& dye =
      colour_along(cloth_, p.system == 0 ? draft::System::kWarp : draft::System::kWeft, thread, point.along);
  const glm::vec3 colour = glm::max(thread_formulas::fibre_colour(texel, {dye.r, dye.g, dye.b}), kDarkestChannel);
  const Lobes& lobes = cloth_.yarns[static_cast<size_t>(body.yarn)].lobes;
  p.lobes = yarn_lobes(lobes, {colour.r, colour.g, colour.b});
  p.lobes.slope_cov +=
      bend_variance(point, textures_[static_cast<size_t>(p.system)][static_cast<size_t>(thread)].fibre_tan, step);
  p.rendered = yarn_lobes(lobes, {p.groove * colour.r, p.groove * colour.g, p.groove * colour.b});
}

/// Adds samples visible from above, and sums over the crossings around them.
void ThreadSampler::add_top_samples(int first, int count, ThreadSamples& out) {
  for (int k = first; k < first + count; ++k) {
    const glm::vec2 at = glm::vec2(part(k, 0.7548776662466927), part(k, 0.5698402909980532)) * grid_.period;
    const auto hit = scene_.first_thread(grid_, at, glm::vec3(0, 0, 1), 0);
    const int layer = hit.system < 0 ? 0 : hit.layer;
    const auto crossing = scene_.crossing_near(layers_[static_cast<size_t>(layer)], at);
    const float warp = warp_around(layer, crossing.warp.thread, crossing.weft.thread);
    out.around_mean += warp, out.around_variance += warp * warp;
    if (hit.system < 0) continue;
    const auto point = scene_.thread_point(hit.system, hit.strand, hit.at);
    const size_t s = static_cast<size_t>(hit.system), thread = static_cast<size_t>(hit.strand.thread);
    Texel texel;
    const glm::vec3 normal = ply_normal_of(hit.system, hit.strand.thread, point, texel);
    const Lobes& lobes = cloth_.yarns[static_cast<size_t>((s == 0 ? cloth_.ends : cloth_.picks)[thread].yarn)].lobes;
    out.top.push_back({hit.system,
                       normal,
                       point.axis + point.around * textures_[s][thread].fibre_tan,
                       {lobes.along_width * lobes.along_width, lobes.across_width * lobes.across_width}});
  }
}

/// The directions into which the surface of a sample faces.
OpenDirections facing_side(const ThreadSample& p, const Directions& all) {
  OpenDirections facing{};
  for (size_t k = 0; k < all.number.size(); ++k) {
    const bool faces = p.side.x * all.x[k] + p.side.y * all.y[k] + p.side.z * all.z[k] > 0;
    facing[k / Directions::kGroup] |= static_cast<uint8_t>((faces ? 1 : 0) << k % Directions::kGroup);
  }
  return facing;
}

/// Those of `open` that are in `these`; the others stay there.
OpenDirections taken_from(OpenDirections& open, const OpenDirections& these) {
  OpenDirections taken;
  for (size_t g = 0; g < taken.size(); ++g) {
    taken[g] = open[g] & these[g];
    open[g] &= static_cast<uint8_t>(~these[g]);
  }
  return taken;
}

void ThreadSampler::find_visible_views(ThreadSample& p, glm::vec3 at, int thread, ViewSet from) {
  const bool through = channel_mean(p.lobes.through) > 0;
  const auto can_see = [&](size_t view) { return through || glm::dot(p.side, views_[view]) > 0; };
  const OpenDirections facing = facing_side(p, high_views_);
  OpenDirections open = facing;
  if (through) open.fill(0xff);
  if (from == ViewSet::kTopAlone) std::fill_n(open.begin(), high_views_.groups() - 1, uint8_t{0});
  shadows_.cast(high_views_, open, at, p.system, thread);
  OpenDirections side = taken_from(open, facing);
  shadows_.cast(high_views_, side, at + p.side * (0.02f * grid_.top), p.system, thread, true);
  for (const OpenDirections& of : {open, side})
    for_each_open(high_views_, of, [&](size_t k) { p.open[high_views_.number[k]] = 1; });
  std::fill_n(p.open.begin() + kHighest, kViewAzimuths, p.open[kHighest]);
  if (from != ViewSet::kLow) return;
  // The lowest views may be occluded from far away, so they are tested one by one. An occluder of two elevations
  // occludes the lower ones, too.
  for (size_t v = kLowViews; v-- > 0;) {
    if (!can_see(v) || (p.open[v + kViewAzimuths] <= 0 && p.open[v + 2 * kViewAzimuths] <= 0)) continue;
    p.open[v] = scene_.threads_block(grid_, at, views_[v], kMaxGridCells, p.system, thread) ? 0.0f : 1.0f;
  }
}

/// Light through the thread, or onto a side of it.
void ThreadSampler::find_transmission(ThreadSample& p, glm::vec3 at, int thread) {
  const OpenDirections facing = facing_side(p, lights_);
  OpenDirections open = facing;
  if (channel_mean(p.lobes.through) > 0) open.fill(0xff);
  shadows_.cast(lights_, open, at, p.system, thread);
  OpenDirections side = taken_from(open, facing);
  // The thread may occlude its own side, so the ray starts a little above it.
  shadows_.cast(lights_, side, at + p.side * (0.02f * grid_.top), p.system, thread, true);
  for (const OpenDirections& of : {open, side})
    for_each_open(lights_, of, [&](size_t k) { p.lights.push_back(lights_.number[k]); });
}

}  // namespace

std::array<glm::vec3, kResponseViews> response_views() {
  std::array<glm::vec3, kResponseViews> out;
  for (int e = 0; e < kResponseElevations; ++e) {
    const float u = static_cast<float>(e) / (kResponseElevations - 1);
    const float z = std::max(u * u, 0.004f), r = std::sqrt(std::max(0.0f, 1 - z * z));
    for (int a = 0; a < kViewAzimuths; ++a) {
      const float t = 2 * kPi * static_cast<float>(a) / kViewAzimuths;
      out[static_cast<size_t>(e * kViewAzimuths + a)] = {r * std::cos(t), r * std::sin(t), z};
    }
  }
  return out;
}

std::array<glm::vec3, kTransmissionLights> transmission_lights() {
  std::array<glm::vec3, kTransmissionLights> out;
  for (int e = 0; e < kTransmissionElevations; ++e) {
    const float u = static_cast<float>(e) / (kTransmissionElevations - 1);
    const float z = std::max(1 - u * u, 0.004f), r = std::sqrt(1 - z * z);
    for (int a = 0; a < kTransmissionAzimuths; ++a) {
      const float t = 2 * kPi * static_cast<float>(a) / kTransmissionAzimuths;
      out[static_cast<size_t>(e * kTransmissionAzimuths + a)] = {r * std::cos(t), r * std::sin(t), -z};
    }
  }
  return out;
}

FacetMoments facet_moments(const glm::vec3& n) { return {n.x, n.y, n.x * n.x, n.y * n.y}; }

Cloth cut(const Cloth& cloth, const CellRect& w) {
  Cloth out;
  out.yarns = cloth.yarns;
  const auto threads = [](const std::vector<ThreadBody>& from, int first, int last, float& length) {
    std::vector<ThreadBody> to(from.begin() + first, from.begin() + last);
    const float start = to.front().centre_mm - 0.5f * to.front().spacing_mm;
    for (ThreadBody& t : to) t.centre_mm -= start;
    length = to.back().centre_mm + 0.5f * to.back().spacing_mm;
    return to;
  };
  out.ends = threads(cloth.ends, w.end0, w.end1, out.width_mm);
  out.picks = threads(cloth.picks, w.pick0, w.pick1, out.depth_mm);
  out.up = BitMatrix(w.pick1 - w.pick0, w.end1 - w.end0);
  for (int p = w.pick0; p < w.pick1; ++p)
    for (int e = w.end0; e < w.end1; ++e) out.up.set(p - w.pick0, e - w.end0, cloth.up.get(p, e));
  return out;
}

ThreadSamples thread_samples(const Cloth& cloth, int count, int transmission_count) {
  ThreadSamples out;
  if (cloth.ends.empty() || cloth.picks.empty()) return out;
  const bool large = cloth.layers.empty() && cloth.ends.size() * cloth.picks.size() > kWholeCrossings;
  const std::vector<Cloth> parts = large ? windows_of(cloth) : std::vector<Cloth>{cloth};
  out.whole = !large;
  const int windows = static_cast<int>(parts.size()), above = kAbove / windows;
  // One sequence over all windows: each continues after the previous one.
  const auto spread = [&](std::vector<ThreadSample>& to, ThreadSampler& sampler, int w, int wanted, bool lit) {
    const int each = std::max(1, wanted / 2 / windows);
    to.resize(static_cast<size_t>((w + 1) * 2 * each));
    for_each_job(2 * each, [&](int i) {
      to[static_cast<size_t>(w * 2 * each + i)] = sampler.sample(i % 2, w * each + i / 2, windows * each, lit);
    });
  };
  for (int w = 0; w < windows; ++w) {
    ThreadSampler sampler(parts[static_cast<size_t>(w)]);
    spread(out.samples, sampler, w, count, false);
    if (transmission_count > 0) spread(out.transmission, sampler, w, transmission_count, true);
    sampler.add_top_samples(w * above, above, out);
  }
  const float scale = 1 / static_cast<float>(windows * above);
  out.around_mean *= scale;
  out.around_variance = std::max(out.around_variance * scale - out.around_mean * out.around_mean, 0.0f);
  for (std::vector<ThreadSample>* samples : {&out.samples, &out.transmission}) {
    std::erase_if(*samples, [](const ThreadSample& p) {
      return p.area <= 0 || std::all_of(p.open.begin(), p.open.end(), [](float o) { return o <= 0; });
    });
  }
  return out;
}

}  // namespace weftlight::light
