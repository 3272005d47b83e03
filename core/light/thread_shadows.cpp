// A thread between two crossings is a few straight pieces of tube between planes at right angles to it. Rings of
// threads around the point are tested, the nearest first, until no remaining direction can reach the next ring. Most
// pieces are out of the way of most directions, so these are tested in groups first, by the boxes that they have to
// cross.

#include "light/thread_shadows.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "platform/vectors.h"

namespace weftlight::light {
namespace {

using cloth::thread_formulas::cubic_through;

// Pieces between two crossings; more for the point's own thread, which rays leave at a slant.
constexpr int kPieces = 6, kOwnPieces = 8;
constexpr int kMaxRings = 24;  // rings of threads
// Of a piece that leans or bends, some is farther than half its height from the line through its ends: in these.
constexpr float kLean = 1.5f;

// What is computed at once: the pieces of a span, or the directions of a group.
constexpr size_t kLanes = 8;
static_assert(kLanes >= kOwnPieces && kLanes == Directions::kGroup);
using Lanes = std::array<float, kLanes>;
constexpr std::array<unsigned, kLanes> kBits{1, 2, 4, 8, 16, 32, 64, 128};

inline size_t first_bit(unsigned bits) { return static_cast<size_t>(std::countr_zero(bits)); }

/// Straight tubes between two sections, relative to the point. Along them s, across them a, z up.
struct Pieces {
  Lanes low, high;  // of both sections: signed distance from the point, and the slopes of the centre line
  Lanes low_slope, high_slope;
  Lanes a, over_width;   // offset of the point in half widths from the axis; 1 over half width
  Lanes b, over_height;  // offset in half heights above the axis; 1 over half height, perpendicular to it
  Lanes slope;
  Lanes before, behind, near, far;  // bounds along, and of the height away from the point
  Lanes behind_point;               // 1: in no direction
  float squareness;                 // of the sections
};

/// The directions of a group that meet a piece, by bits. kFull: its section is fuller than an ellipse. There a ray is
/// deepest between where it is nearest to the axis and where it crosses that corner's diagonal; it is tested at both
/// and in the middle.
template <bool kFull>
inline unsigned met_by(const Pieces& pieces, size_t piece, const float* __restrict across,
                       const float* __restrict along, const float* __restrict up) {
  constexpr float kFar = 1e9f, kUpright = 1e-6f;
  const float low = pieces.low[piece], low_slope = pieces.low_slope[piece], high = pieces.high[piece],
              high_slope = pieces.high_slope[piece], a = pieces.a[piece], b = pieces.b[piece],
              over_width = pieces.over_width[piece], over_height = pieces.over_height[piece],
              slope = pieces.slope[piece], q = pieces.squareness;
  unsigned met = 0;
  for (size_t k = 0; k < kLanes; ++k) {
    const float a1 = across[k] * over_width, b1 = (up[k] - along[k] * slope) * over_height;
    // The part of each ray between the sections, which are perpendicular to the bent line.
    const float in = along[k] + up[k] * low_slope, out = along[k] + up[k] * high_slope;
    const float run = std::abs(in) > kUpright ? in : kUpright, leave = std::abs(out) > kUpright ? out : kUpright;
    const float enters = low / run, exits = high / leave;
    const float first = std::max(std::max(run > 0 ? enters : 0.0f, leave > 0 ? 0.0f : exits), 0.0f);
    const float last = std::min(run > 0 ? kFar : enters, leave > 0 ? exits : kFar);
    const float nearest = -(a * a1 + b * b1) / (a1 * a1 + b1 * b1);
    const auto square_at = [&](float at) {
      const float t = std::min(std::max(at, first), last);
      const float x = a + t * a1, y = b + t * b1, xx = x * x, yy = y * y, r = xx + yy;
      return kFull ? 0.5f * (r + std::sqrt(std::max(r * r - 4 * q * xx * yy, 0.0f))) : r;
    };
    float deepest = square_at(nearest);
    if (kFull) {
      const float side = (a + nearest * a1) * (b + nearest * b1) < 0 ? -1.0f : 1.0f, turn = a1 - side * b1;
      const float corner = std::abs(turn) > kUpright ? (side * b - a) / turn : nearest;
      deepest = std::min(deepest, std::min(square_at(corner), square_at(0.5f * (nearest + corner))));
    }
    const unsigned inside = deepest >= 1.0f ? 0u : kBits[k];
    met |= last > first ? inside : 0u;
  }
  return met;
}

/// A thread near the point.
struct Near {
  int thread;
  float centre;
  cloth::thread_formulas::ThreadSection body;
  float wide;  // half of its spacing or of its width, whichever is larger
};

/// A thread from one crossing to the next.
struct Span {
  glm::vec4 curve;
  glm::vec2 thin, thinner;    // 1 over half width and half height at its start; their change to its end
  float start, step;          // along, from the point
  float aside, aside_change;  // offset of the point from the centre at its start; its change to its end
};

/// cubic_at() of shaders/thread_curve.glsl by component, since a compiler vectorises no loop with a glm::vec3.
struct Cubic {
  float x, y, z, w;
  float height(float at) const { return x + at * (y + at * (z + at * w)); }
  float slope(float at) const { return y + at * (2 * z + at * 3 * w); }
  float bend(float at) const { return 2 * z + at * 6 * w; }
};

/// The pieces of a span, for a point at `height`; up: 1, or -1 for directions that go down.
inline void cut_into(Pieces& out, const Span& span, int pieces, float height, float up) {
  const Cubic curve{span.curve.x, span.curve.y, span.curve.z, span.curve.w};
  const float wide = span.thin.x, wider = span.thinner.x, high = span.thin.y, higher = span.thinner.y;
  const float step = span.step, start = span.start, aside = span.aside, change = span.aside_change;
  const float count = static_cast<float>(pieces), per_piece = 1 / count, length = step / count;
  for (size_t k = 0; k < kLanes; ++k) {
    const float n = static_cast<float>(static_cast<int>(k)), middle = n + 0.5f;
    const float first = n * per_piece * step, last = (n + 1) * per_piece * step, from = start + n * length;
    const float z0 = curve.height(first), z1 = curve.height(last), m0 = curve.slope(first), m1 = curve.slope(last);
    const float over_width = wide + wider * (middle * per_piece), over_height = high + higher * (middle * per_piece);
    const float slope = (z1 - z0) / length, stretch = std::sqrt(1 + slope * slope), upright = over_height / stretch;
    const float dip = curve.bend(middle * length) * length * length / 12;
    out.low[k] = from + (z0 - height) * m0, out.low_slope[k] = m0;
    out.high[k] = from + length + (z1 - height) * m1, out.high_slope[k] = m1;
    out.slope[k] = slope, out.over_width[k] = over_width, out.over_height[k] = upright;
    out.a[k] = (aside + change * (middle / count)) * over_width;
    // At the mean height of the bent line.
    out.b[k] = (height - (z0 - dip - from * slope)) * upright;
    const float half = 1 / over_height, reach = kLean * half;
    const float away0 = (z0 - height) * up, away1 = (z1 - height) * up;
    const float near = std::min(away0, away1), far = std::max(away0, away1);
    out.before[k] = from - reach, out.behind[k] = from + length + reach;
    out.near[k] = std::max(near - reach, 0.0f), out.far[k] = far + reach;
    out.behind_point[k] = far + half < 0 ? 1.0f : 0.0f;
  }
}

/// A box around a thread, relative to the point: across it, along it, and in height away from the point.
struct Box {
  float left, right, before, behind, near, far;
};

/// Groups of directions, with bounds of where they are at a height of 1, across a thread and along it.
struct Groups {
  static constexpr size_t kMost = Directions::kMostGroups;
  size_t count = 0;
  std::array<uint8_t, kMost> group;
  std::array<float, kMost> left, right, before, behind;
  // Of all of them, and of the point.
  float leftmost = 0, rightmost = 0, first = 0, last = 0;

  void clear() {
    count = 0;
    leftmost = rightmost = first = last = 0;
  }
  void add(size_t g, float left_of, float right_of, float before_of, float behind_of) {
    group[count] = static_cast<uint8_t>(g);
    left[count] = left_of, right[count] = right_of, before[count] = before_of, behind[count++] = behind_of;
  }
  void extend() {
    for (size_t i = 0; i < count; ++i) {
      leftmost = std::min(leftmost, left[i]), rightmost = std::max(rightmost, right[i]);
      first = std::min(first, before[i]), last = std::max(last, behind[i]);
    }
  }
  /// Out of the way of all of them? box: from the point's height on.
  bool may_meet(const Box& box) const {
    return rightmost * box.far >= box.left && leftmost * box.far <= box.right && last * box.far >= box.before &&
           first * box.far <= box.behind;
  }
};

/// Heights of a thread between two crossings, by the control points of its curve. from, to: height and slope there.
void set_heights(Box& box, const glm::vec2& from, const glm::vec2& to, float step, float reach, float height,
                 float up) {
  const float third = step / 3, a = from.x + from.y * third, b = to.x - to.y * third;
  const float low = (std::min({from.x, a, b, to.x}) - height) * up,
              high = (std::max({from.x, a, b, to.x}) - height) * up;
  box.near = std::max(std::min(low, high) - reach, 0.0f), box.far = std::max(low, high) + reach;
}

/// Those that may meet something in the box.
inline void choose(Groups& out, const Groups& all, const Box& box) {
  const auto [l, r, b, e, near, far] = box;
  for (size_t at = 0; at < all.count; at += kLanes) {
    unsigned may = 0;
    for (size_t k = 0; k < kLanes; ++k) {
      const size_t i = at + k;
      const float left = std::min(all.left[i] * near, all.left[i] * far),
                  right = std::max(all.right[i] * near, all.right[i] * far),
                  before = std::min(all.before[i] * near, all.before[i] * far),
                  behind = std::max(all.behind[i] * near, all.behind[i] * far);
      may |= (right >= l) & (left <= r) & (behind >= b) & (before <= e) ? kBits[k] : 0u;
    }
    for (; may != 0; may &= may - 1) {
      const size_t i = at + first_bit(may);
      if (i < all.count) out.add(all.group[i], all.left[i], all.right[i], all.before[i], all.behind[i]);
    }
  }
}

/// The pieces that a direction of group i may meet, by bits; box: of all of them.
inline unsigned may_meet(const Groups& groups, size_t i, const Pieces& pieces, const Box& box) {
  const float left = groups.left[i], right = groups.right[i], before = groups.before[i], behind = groups.behind[i];
  unsigned may = 0;
  for (size_t k = 0; k < kLanes; ++k) {
    const float near = pieces.near[k], far = pieces.far[k];
    const bool meets = (pieces.behind_point[k] <= 0) & (std::max(right * near, right * far) >= box.left) &
                       (std::min(left * near, left * far) <= box.right) &
                       (std::max(behind * near, behind * far) >= pieces.before[k]) &
                       (std::min(before * near, before * far) <= pieces.behind[k]);
    may |= meets ? kBits[k] : 0u;
  }
  return may;
}

}  // namespace

void Directions::add(const glm::vec3& w, size_t i) {
  const float height = std::max(std::abs(w.z), 1e-3f), u = w.x / height, v = w.y / height;
  const float far = std::sqrt(w.x * w.x + w.y * w.y) / height;
  if (number.size() % kGroup == 0) {
    least_x.push_back(u), most_x.push_back(u), least_y.push_back(v), most_y.push_back(v);
    least_slant.push_back(far), most_slant.push_back(far);
  } else {
    least_x.back() = std::min(least_x.back(), u), most_x.back() = std::max(most_x.back(), u);
    least_y.back() = std::min(least_y.back(), v), most_y.back() = std::max(most_y.back(), v);
    least_slant.back() = std::min(least_slant.back(), far), most_slant.back() = std::max(most_slant.back(), far);
  }
  x.push_back(w.x), y.push_back(w.y), z.push_back(w.z);
  slant.push_back(far);
  number.push_back(static_cast<uint16_t>(i));
}

void Directions::finish_group() {
  while (number.size() % kGroup != 0) add({x.back(), y.back(), z.back()}, number.back());
}

/// The directions of a cast, and those that it still follows.
struct ThreadShadows::Rays {
  const Directions& all;
  OpenDirections& open;
  OpenDirections left{};  // open, and not yet above or below all threads
  OpenDirections met{};
  std::array<Groups, 2> groups;  // of `left`, for threads of each system

  Rays(const Directions& directions, OpenDirections& still_open) : all(directions), open(still_open) {
    for (Groups& of : groups) of.left = of.right = of.before = of.behind = {};
  }
  /// Gives up directions that end before `away`, where threads reach to `depth`.
  void leave_before(float depth, float away) {
    groups[0].clear(), groups[1].clear();
    for (size_t g = 0; g < all.groups(); ++g) {
      if (left[g] != 0 && depth * all.least_slant[g] < away) left[g] &= static_cast<uint8_t>(reaching(g, depth, away));
      if (left[g] == 0) continue;
      groups[0].add(g, all.least_x[g], all.most_x[g], all.least_y[g], all.most_y[g]);
      groups[1].add(g, all.least_y[g], all.most_y[g], all.least_x[g], all.most_x[g]);
    }
    groups[0].extend(), groups[1].extend();
  }
  void meet(const Groups& groups_near, const Pieces& pieces, int count, const Box& box, bool warp) {
    const float *across = (warp ? all.x : all.y).data(), *along = (warp ? all.y : all.x).data(), *up = all.z.data();
    const bool full = pieces.squareness > 0;
    for (size_t i = 0; i < groups_near.count; ++i) {
      const size_t g = groups_near.group[i], first = g * kLanes;
      unsigned open_of = left[g] & ~unsigned{met[g]};
      if (open_of == 0) continue;
      const unsigned of_span = (1u << count) - 1;
      for (unsigned may = of_span & may_meet(groups_near, i, pieces, box); may != 0 && open_of != 0; may &= may - 1)
        open_of &= ~(full ? met_by<true>(pieces, first_bit(may), across + first, along + first, up + first)
                          : met_by<false>(pieces, first_bit(may), across + first, along + first, up + first));
      met[g] |= static_cast<uint8_t>(left[g] & ~open_of);
    }
  }
  void remove_met() {
    for (size_t i = 0; i < groups[0].count; ++i) {
      const size_t g = groups[0].group[i];
      open[g] &= static_cast<uint8_t>(~met[g]), left[g] &= static_cast<uint8_t>(~met[g]);
      met[g] = 0;
    }
  }

 private:
  unsigned reaching(size_t g, float depth, float away) const {
    unsigned reach = 0;
    if (depth * all.most_slant[g] < away) return reach;
    for (size_t k = 0; k < kLanes; ++k) reach |= depth * all.slant[g * kLanes + k] < away ? 0u : kBits[k];
    return reach;
  }
};

/// The point and the threads around it, counted from those over and under it.
struct ThreadShadows::Around {
  static constexpr int kMiddle = kMaxRings + 1;
  glm::vec3 from;
  int system, thread;
  bool only_it, down;
  float depth = 0;       // of the layer's threads, from the point
  glm::ivec2 middle{0};  // indices in the layer
  glm::vec2 base{0};     // origin of its period
  std::array<std::array<Near, 2 * kMiddle + 1>, 2> threads;

  const Near& near(int of, int step) const { return threads[of == 0 ? 0 : 1][static_cast<size_t>(kMiddle + step)]; }
  void fetch(ThreadScene& scene, const ThreadGrid& g, int of, int step) {
    const int n = g.count[of], at = middle[of] + step;
    const int period = at >= 0 ? at / n : -((-at + n - 1) / n), index = g.first[of] + at - period * n;
    const auto body = scene.thread_body(of, index);
    threads[static_cast<size_t>(of)][static_cast<size_t>(kMiddle + step)] = {
        index, body.centre + base[of] + static_cast<float>(period) * g.period[of], body,
        std::max(cloth::thread_formulas::furthest_side(body), body.half_width) + g.aside};
  }
};

ThreadShadows::ThreadShadows(ThreadScene& scene) : scene_(scene) {
  const int layers = scene.grid().layers;
  for (int i = 0; i < layers; ++i) layers_.push_back(scene.thread_layer(i, 1));
}

/// Tests thread `across` of a system between threads `along` and `along + 1` of the other.
void ThreadShadows::cast_span(Rays& rays, const ThreadGrid& g, const Around& around, int system, int across,
                              int along) {
  const int other = 1 - system;
  const bool warp = system == 0;
  const Near &it = around.near(system, across), &first = around.near(other, along),
             &second = around.near(other, along + 1);
  if ((system == around.system && it.thread == around.thread) != around.only_it) return;
  const auto place = [&](const Near& of) {
    if (g.aside == 0) return of.centre;
    return of.centre + (warp ? scene_.aside_at(it.thread, of.thread).y : scene_.aside_at(of.thread, it.thread).x);
  };
  const float aside = around.from[system] - it.centre, start = place(first) - around.from[other],
              step = place(second) - place(first), lean = it.body.half_height;
  Box box{-aside - it.wide, it.wide - aside, start - kLean * lean, start + step + kLean * lean, 0, around.depth};
  const Groups& all = rays.groups[static_cast<size_t>(system)];
  if (!all.may_meet(box)) return;
  Groups near;
  platform::with_widest_vectors([&] { choose(near, all, box); });
  if (near.count == 0) return;
  const glm::vec4 here = scene_.crossing_at(warp ? it.thread : first.thread, warp ? first.thread : it.thread);
  const glm::vec4 next = scene_.crossing_at(warp ? it.thread : second.thread, warp ? second.thread : it.thread);
  const glm::vec2 from = warp ? glm::vec2(here.x, here.y) : glm::vec2(here.z, here.w),
                  to = warp ? glm::vec2(next.x, next.y) : glm::vec2(next.z, next.w);
  const glm::vec3 section = scene_.section_at(g, system, it.thread, it.body, first.thread),
                  next_section = scene_.section_at(g, system, it.thread, it.body, second.thread);
  const float height = around.from.z, up = around.down ? -1.0f : 1.0f;
  set_heights(box, from, to, step, kLean * std::max(section.y, next_section.y), height, up);
  if (box.far < 0) return;
  Span span{{}, 1.0f / glm::vec2(section), {}, start, step, aside - section.z, section.z - next_section.z};
  span.thinner = 1.0f / glm::vec2(next_section) - span.thin;
  span.curve = cubic_through(from.x, from.y, to.x, to.y, step);
  const int pieces = around.only_it ? kOwnPieces : kPieces;
  platform::with_widest_vectors([&] {
    Groups nearer;
    choose(nearer, near, box);
    if (nearer.count == 0) return;
    Pieces of;
    of.squareness = it.body.squareness;
    cut_into(of, span, pieces, height, up);
    rays.meet(nearer, of, pieces, box, warp);
  });
}

void ThreadShadows::cast_layer(Rays& rays, const ThreadGrid& g, Around& around) {
  around.depth = around.down ? around.from.z - g.bottom : g.top - around.from.z;
  rays.left = rays.open;
  for (int s = 0; s < 2; ++s) around.fetch(scene_, g, s, 0);
  for (int ring = 0; ring <= kMaxRings; ++ring) {
    float away = 1e9f;  // distance from the point to the remaining threads
    for (int s = 0; s < 2; ++s) {
      for (const int turn : {-1, 1}) {
        around.fetch(scene_, g, s, turn * (ring + 1));
        const Near& next = around.near(s, turn * ring);
        away = std::min(away, static_cast<float>(turn) * (next.centre - around.from[s]) - next.wide);
      }
    }
    rays.leave_before(around.depth, away);
    if (rays.groups[0].count == 0) return;
    // Threads that cross the point's own first, since they are nearest.
    for (const int system : {1 - around.system, around.system}) {
      for (int across = -ring; across <= ring; ++across) {
        const bool rim = std::abs(across) == ring;
        for (int along = -ring - 1; along <= ring; along += rim || along == ring ? 1 : 2 * ring + 1)
          cast_span(rays, g, around, system, across, along);
      }
      rays.remove_met();
    }
  }
}

void ThreadShadows::cast(const Directions& all, OpenDirections& open, const glm::vec3& from, int system, int thread,
                         bool only_it) {
  Around around;
  around.from = from, around.system = system, around.thread = thread, around.only_it = only_it;
  around.down = all.down();
  Rays rays(all, open);
  for (const ThreadGrid& g : layers_) {
    for (int s = 0; s < 2; ++s) {
      around.base[s] = std::floor(from[s] / g.period[s]) * g.period[s];
      around.middle[s] = scene_.thread_at(g, s, from[s] - around.base[s]) - g.first[s];
    }
    cast_layer(rays, g, around);
  }
}

}  // namespace weftlight::light
