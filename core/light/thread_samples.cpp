// Based on: Roberts 2018 (R2 and R3, even spreads of points in two and three dimensions).

#include "light/thread_samples.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/loops.h"
#include "cloth/thread_scene.h"
#include "light/thread_shadows.h"
#include "light/yarn_lobes.h"

namespace weftlight::light {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kWindow = 64, kWindows = 4;  // threads and windows a side, else
constexpr int kMaxGridCells = 48;          // of crossings, along a ray
constexpr int kAbove = 1 << 13;            // places seen from above
// Of the turns around a thread, denser near its ridge: the underside is hardly seen.
constexpr float kEvenTurns = 0.55f;

constexpr size_t kHighest = (kResponseElevations - 1) * kViewAzimuths;  // the view from straight above
constexpr size_t kAlong = (kBehindElevations - 1) * kBehindAzimuths;  // from there on lights from behind reach nothing

/// Coordinate 0..1 of point k of an even spread.
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

/// Places of one cloth.
class Placer {
 public:
  explicit Placer(const Cloth& cloth)
      : cloth_(cloth),
        scene_(cloth),
        shadows_(scene_),
        grid_(scene_.grid()),
        textures_(thread_textures(cloth)),
        views_(response_views()) {
    for (size_t v = kLowViews; v <= kHighest; ++v) high_views_.add(views_[v], v);
    const auto lights = transmission_lights();
    for (size_t i = 0; i < kAlong; ++i) lights_.add(lights[i], i);
    for (int i = 0; i < grid_.layers; ++i) layers_.push_back(scene_.thread_layer(i, 1));
  }
  /// Place k of `count` of a system; area 0 where there is none. lit: by light from behind; those that none reaches are
  /// left out.
  ThreadSample place(int system, int k, int count, bool lit);
  void look_down(int first, int count, ThreadSamples& out);

 private:
  float length(int system) const { return system == 0 ? cloth_.depth_mm : cloth_.width_mm; }
  float warp_around(int layer, int end, int pick) const;
  glm::vec3 plied(int system, int thread, const thread_formulas::ThreadScene::ThreadPoint& point, Texel& texel);
  void dress(ThreadSample& p, int thread, const thread_formulas::ThreadScene::ThreadPoint& point, float step);
  glm::vec3 bend_over(const thread_formulas::ThreadScene::ThreadPoint& point, float fibre_tan, float step) const;
  enum class Seen {
    kTopAlone,
    kHigh,
    kLow
  };  // views: that from straight above, the high ones, those along the cloth, too
  void look_around(ThreadSample& p, glm::vec3 at, int thread, Seen from);
  void look_behind(ThreadSample& p, glm::vec3 at, int thread);

  const Cloth& cloth_;
  ThreadScene scene_;
  ThreadShadows shadows_;
  thread_formulas::ThreadScene::ThreadGrid grid_;
  std::vector<thread_formulas::ThreadScene::ThreadGrid> layers_;
  std::array<std::vector<ThreadTexture>, 2> textures_;
  std::array<glm::vec3, kResponseViews> views_;
  Directions high_views_, lights_;  // behind
};

/// The warp's share of the crossings around one, by a tent: what mips of four yarns see, read between texels.
float Placer::warp_around(int layer, int end, int pick) const {
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

ThreadSample Placer::place(int system, int k, int count, bool lit) {
  const glm::vec2 at = glm::vec2(part(k, 0.8191725133961645), part(k, 0.6710436067037893)) * grid_.period;
  const float u = 2 * part(k, 0.5497004779019703) - 1;
  const float turn = kPi * u * (kEvenTurns + (1 - kEvenTurns) * u * u),
              density = kPi * (kEvenTurns + 3 * (1 - kEvenTurns) * u * u);
  const int layer = k % grid_.layers;
  const auto crossing = scene_.crossing_near(layers_[static_cast<size_t>(layer)], at);
  const auto& s = system == 0 ? crossing.warp : crossing.weft;
  const float along = system == 0 ? at.y : at.x;
  const glm::vec3 c = scene_.strand_curve(s, along);
  const float lean = std::sqrt(1 + c.y * c.y), x = std::sin(turn), y = std::cos(turn);
  const glm::vec2 half = 1.0f / scene_.strand_thin(s, along);
  const float around = std::sqrt(half.x * half.x * y * y + half.y * half.y * x * x);
  // Sections stand at right angles to a bent line: outside the bend they are further apart.
  const float apart = lean * (1 - half.y * y * c.z / (lean * lean * lean));
  const float room = (system == 0 ? cloth_.ends : cloth_.picks)[static_cast<size_t>(s.thread)].spacing_mm;
  ThreadSample p;
  p.system = system;
  if (apart <= 0 || room <= 0) return p;
  p.area = around * apart * density * 2 * static_cast<float>(grid_.layers) / (room * static_cast<float>(count));
  const float aside = s.centre + half.x * x, level = c.x + half.y * y / lean;
  const float ahead = along - half.y * y * c.y / lean;
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
  dress(p, s.thread, scene_.thread_point(system, s, where), 1 / std::sqrt(static_cast<float>(count)));
  if (lit) look_behind(p, where, s.thread);
  look_around(p, where, s.thread, !lit ? Seen::kLow : p.behind.empty() ? Seen::kTopAlone : Seen::kHigh);
  return p;
}

/// The normal between plies, and the pattern there, between fibres at its mean.
glm::vec3 Placer::plied(int system, int thread, const thread_formulas::ThreadScene::ThreadPoint& point, Texel& texel) {
  const ThreadTexture& t = textures_[static_cast<size_t>(system)][static_cast<size_t>(thread)];
  const float share = point.along / length(system);
  texel = texture_at(t, thread_formulas::texture_point(t, share - std::floor(share), point.turn, 1, 1));
  return t.plies > 1 ? scene_.ply_normal(point, t, texel.ply, length(system)) : point.normal;
}

/// Variances of the slopes along the thread of the surface that a place stands for, as lobes hold them: along the
/// fibre, between both, across it. A narrow highlight on a bend would else lie on few places, or on none, by chance.
/// step: of the places, over a repeat.
glm::vec3 Placer::bend_over(const thread_formulas::ThreadScene::ThreadPoint& point, float fibre_tan, float step) const {
  constexpr float kRepeat = 8;  // crossings
  constexpr float kMax = 0.04f;
  const float turned = point.bend.x * kRepeat * grid_.spacing * step, tan2 = fibre_tan * fibre_tan;
  // Places lie evenly, not on a grid: so that neighbours overlap, twice the variance of a box.
  return std::min(turned * turned / 6, kMax) / (1 + tan2) * glm::vec3(1, -fibre_tan, tan2);
}

/// Normals, fibre and lobes, as core/reference/trace.cpp has them.
void Placer::dress(ThreadSample& p, int thread, const thread_formulas::ThreadScene::ThreadPoint& point, float step) {
  Texel texel;
  p.side = point.normal;
  p.normal = plied(p.system, thread, point, texel);
  p.fibre = point.axis + point.around * textures_[static_cast<size_t>(p.system)][static_cast<size_t>(thread)].fibre_tan;
  p.groove = texel.groove;
  const ThreadBody& body = (p.system == 0 ? cloth_.ends : cloth_.picks)[static_cast<size_t>(thread)];
  const glm::vec3 colour =
      glm::max(thread_formulas::fibre_colour(texel, {body.colour.r, body.colour.g, body.colour.b}), kDarkestChannel);
  const Lobes& lobes = cloth_.yarns[static_cast<size_t>(body.yarn)].lobes;
  p.lobes = yarn_lobes(lobes, {colour.r, colour.g, colour.b});
  p.lobes.slope_cov +=
      bend_over(point, textures_[static_cast<size_t>(p.system)][static_cast<size_t>(thread)].fibre_tan, step);
  p.drawn = yarn_lobes(lobes, {p.groove * colour.r, p.groove * colour.g, p.groove * colour.b});
}

/// Adds what is seen from above; of the crossings around it, sums.
void Placer::look_down(int first, int count, ThreadSamples& out) {
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
    const glm::vec3 normal = plied(hit.system, hit.strand.thread, point, texel);
    const Lobes& lobes = cloth_.yarns[static_cast<size_t>((s == 0 ? cloth_.ends : cloth_.picks)[thread].yarn)].lobes;
    out.top.push_back({hit.system,
                       normal,
                       point.axis + point.around * textures_[s][thread].fibre_tan,
                       {lobes.along_width * lobes.along_width, lobes.across_width * lobes.across_width}});
  }
}

void Placer::look_around(ThreadSample& p, glm::vec3 at, int thread, Seen from) {
  const auto can_see = [&](size_t view) {
    return glm::dot(p.side, views_[view]) > 0 || channel_mean(p.lobes.through) > 0;
  };
  Directions open;
  open.reserve(high_views_.size());
  for (size_t k = from == Seen::kTopAlone ? high_views_.size() - 1 : 0; k < high_views_.size(); ++k)
    if (can_see(high_views_.number[k])) open.take(high_views_, k);
  shadows_.cast(open, at, p.system, thread);
  Directions facing;
  facing.reserve(open.size());
  for (size_t k = 0; k < open.size(); ++k) {
    const uint16_t v = open.number[k];
    if (glm::dot(p.side, views_[v]) > 0) facing.take(open, k);
    else p.open[v] = 1;
  }
  shadows_.cast(facing, at + p.side * (0.02f * grid_.top), p.system, thread, true);
  for (const uint16_t v : facing.number) p.open[v] = 1;
  std::fill_n(p.open.begin() + kHighest, kViewAzimuths, p.open[kHighest]);
  if (from != Seen::kLow) return;
  // What might stand before these is far off: one by one. What stands before two elevations stands before the lower
  // ones.
  for (size_t v = kLowViews; v-- > 0;) {
    if (!can_see(v) || (p.open[v + kViewAzimuths] <= 0 && p.open[v + 2 * kViewAzimuths] <= 0)) continue;
    p.open[v] = scene_.threads_block(grid_, at, views_[v], kMaxGridCells, p.system, thread) ? 0.0f : 1.0f;
  }
}

/// Through the thread, or onto a side of it.
void Placer::look_behind(ThreadSample& p, glm::vec3 at, int thread) {
  Directions through, side;
  through.reserve(lights_.size()), side.reserve(lights_.size());
  for (size_t k = 0; k < lights_.size(); ++k) {
    const bool faces = p.side.x * lights_.x[k] + p.side.y * lights_.y[k] + p.side.z * lights_.z[k] > 0;
    if (faces) side.take(lights_, k);
    else if (channel_mean(p.lobes.through) > 0) through.take(lights_, k);
  }
  shadows_.cast(through, at, p.system, thread);
  shadows_.cast(side, at, p.system, thread);
  // The thread itself may stand before a side, too: from a little above it.
  shadows_.cast(side, at + p.side * (0.02f * grid_.top), p.system, thread, true);
  p.behind = through.number;
  p.behind.insert(p.behind.end(), side.number.begin(), side.number.end());
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

std::array<glm::vec3, kBehindLights> transmission_lights() {
  std::array<glm::vec3, kBehindLights> out;
  for (int e = 0; e < kBehindElevations; ++e) {
    const float u = static_cast<float>(e) / (kBehindElevations - 1);
    const float z = std::max(1 - u * u, 0.004f), r = std::sqrt(1 - z * z);
    for (int a = 0; a < kBehindAzimuths; ++a) {
      const float t = 2 * kPi * static_cast<float>(a) / kBehindAzimuths;
      out[static_cast<size_t>(e * kBehindAzimuths + a)] = {r * std::cos(t), r * std::sin(t), -z};
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

ThreadSamples thread_samples(const Cloth& cloth, int count, int behind) {
  ThreadSamples out;
  if (cloth.ends.empty() || cloth.picks.empty()) return out;
  const bool large = cloth.layers.empty() && cloth.ends.size() * cloth.picks.size() > kWholeCrossings;
  const std::vector<Cloth> parts = large ? windows_of(cloth) : std::vector<Cloth>{cloth};
  out.whole = !large;
  const int windows = static_cast<int>(parts.size()), above = kAbove / windows;
  // One spread over all windows: each takes the points that the one before left.
  const auto spread = [&](std::vector<ThreadSample>& to, Placer& placer, int w, int wanted, bool lit) {
    const int each = std::max(1, wanted / 2 / windows);
    to.resize(static_cast<size_t>((w + 1) * 2 * each));
    for_each_job(2 * each, [&](int i) {
      to[static_cast<size_t>(w * 2 * each + i)] = placer.place(i % 2, w * each + i / 2, windows * each, lit);
    });
  };
  for (int w = 0; w < windows; ++w) {
    Placer placer(parts[static_cast<size_t>(w)]);
    spread(out.places, placer, w, count, false);
    if (behind > 0) spread(out.behind, placer, w, behind, true);
    placer.look_down(w * above, above, out);
  }
  const float scale = 1 / static_cast<float>(windows * above);
  out.around_mean *= scale;
  out.around_variance = std::max(out.around_variance * scale - out.around_mean * out.around_mean, 0.0f);
  for (std::vector<ThreadSample>* places : {&out.places, &out.behind}) {
    std::erase_if(*places, [](const ThreadSample& p) {
      return p.area <= 0 || std::all_of(p.open.begin(), p.open.end(), [](float o) { return o <= 0; });
    });
  }
  return out;
}

}  // namespace weftlight::light
