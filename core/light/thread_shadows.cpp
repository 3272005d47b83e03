// A thread between two crossings is a few straight pieces of elliptic tube between vertical planes. Rings of threads
// around the point are tested, the nearest first, until no remaining direction can reach the next ring.

#include "light/thread_shadows.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "platform/vectors.h"

namespace weftlight::light {
namespace {

// Pieces between two crossings; more for the point's own thread, which rays leave at a slant.
constexpr int kPieces = 6, kOwnPieces = 8;
constexpr int kMaxRings = 24;  // rings of threads

/// A straight tube between two sections, relative to the point. Along it s, across it a, z up.
struct Piece {
  float low, high;  // of both sections: signed distance from the point, and the slopes of the centre line
  float low_slope, high_slope;
  float a, over_width;   // offset of the point in half widths from the axis; 1 over half width
  float b, over_height;  // offset in half heights above the axis; 1 over half height, perpendicular to it
  float slope;
};

/// Clears the directions that meet the piece.
inline void occlude_all(const Piece& p, size_t count, const float* __restrict across, const float* __restrict along,
                        const float* __restrict up, float* __restrict clear) {
  constexpr float kFar = 1e9f, kUpright = 1e-6f;
  for (size_t k = 0; k < count; ++k) {
    const float a1 = across[k] * p.over_width, b1 = (up[k] - along[k] * p.slope) * p.over_height;
    // The part of each ray between the sections, which are perpendicular to the bent line.
    const float in = along[k] + up[k] * p.low_slope, out = along[k] + up[k] * p.high_slope;
    const float run = std::abs(in) > kUpright ? in : kUpright, leave = std::abs(out) > kUpright ? out : kUpright;
    const float enters = p.low / run, exits = p.high / leave;
    const float first = std::max(std::max(run > 0 ? enters : 0.0f, leave > 0 ? 0.0f : exits), 0.0f);
    const float last = std::min(run > 0 ? kFar : enters, leave > 0 ? exits : kFar);
    const float nearest = -(p.a * a1 + p.b * b1) / (a1 * a1 + b1 * b1);
    const float t = std::min(std::max(nearest, first), last);
    const float x = p.a + t * a1, y = p.b + t * b1;
    const float outside = x * x + y * y >= 1.0f ? 1.0f : 0.0f;
    clear[k] *= last > first ? outside : 1.0f;
  }
}

void occlude(const Piece& p, size_t count, const float* across, const float* along, const float* up, float* clear) {
  platform::with_widest_vectors([=, &p] { occlude_all(p, count, across, along, up, clear); });
}

void keep_unoccluded(Directions& of, const std::vector<float>& clear) {
  size_t kept = 0;
  for (size_t k = 0; k < of.size(); ++k) {
    if (clear[k] <= 0) continue;
    of.x[kept] = of.x[k], of.y[kept] = of.y[k], of.z[kept] = of.z[k];
    of.slant[kept] = of.slant[k];
    of.number[kept++] = of.number[k];
  }
  for (std::vector<float>* v : {&of.x, &of.y, &of.z, &of.slant}) v->resize(kept);
  of.number.resize(kept);
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

/// Piece k of `pieces`, for a point at `height`; over: 1 over its half width and half height.
Piece piece_of(const Span& span, int k, int pieces, float height, const glm::vec3& low, const glm::vec3& high,
               const glm::vec2& over) {
  const float length = span.step / static_cast<float>(pieces), from = span.start + static_cast<float>(k) * length;
  const float bend = cloth::thread_formulas::cubic_at(span.curve, (static_cast<float>(k) + 0.5f) * length).z;
  Piece p;
  p.low = from + (low.x - height) * low.y, p.low_slope = low.y;
  p.high = from + length + (high.x - height) * high.y, p.high_slope = high.y;
  p.slope = (high.x - low.x) / length;
  p.over_width = over.x, p.over_height = over.y / std::sqrt(1 + p.slope * p.slope);
  p.a = (span.aside + span.aside_change * ((static_cast<float>(k) + 0.5f) / static_cast<float>(pieces))) * p.over_width;
  // At the mean height of the bent line.
  p.b = (height - (low.x - bend * length * length / 12 - from * p.slope)) * p.over_height;
  return p;
}

}  // namespace

void Directions::add(const glm::vec3& w, size_t i) {
  x.push_back(w.x), y.push_back(w.y), z.push_back(w.z);
  slant.push_back(std::sqrt(w.x * w.x + w.y * w.y) / std::max(std::abs(w.z), 1e-3f));
  number.push_back(static_cast<uint16_t>(i));
}

void Directions::reserve(size_t count) {
  for (std::vector<float>* v : {&x, &y, &z, &slant}) v->reserve(count);
  number.reserve(count);
}

void Directions::add_from(const Directions& from, size_t k) {
  x.push_back(from.x[k]), y.push_back(from.y[k]), z.push_back(from.z[k]);
  slant.push_back(from.slant[k]);
  number.push_back(from.number[k]);
}

/// The point and the threads around it, counted from those over and under it.
struct ThreadShadows::Around {
  static constexpr int kMiddle = kMaxRings + 1;
  glm::vec3 from;
  int system, thread;
  bool only_it, down;
  glm::vec2 low{0}, high{0};  // bounds of what the directions cross, from the point
  glm::ivec2 middle{0};       // indices in the layer
  glm::vec2 base{0};          // origin of its period
  std::array<std::array<Near, 2 * kMiddle + 1>, 2> threads;

  const Near& near(int of, int step) const {
    return threads[static_cast<size_t>(of)][static_cast<size_t>(kMiddle + step)];
  }
  void fetch(ThreadScene& scene, const ThreadGrid& g, int of, int step) {
    const int n = g.count[of], at = middle[of] + step;
    const int period = at >= 0 ? at / n : -((-at + n - 1) / n), index = g.first[of] + at - period * n;
    const auto body = scene.thread_body(of, index);
    threads[static_cast<size_t>(of)][static_cast<size_t>(kMiddle + step)] = {
        index, body.centre + base[of] + static_cast<float>(period) * g.period[of], body,
        std::max(cloth::thread_formulas::furthest_side(body), body.half_width)};
  }
  bool crosses(int axis, float first, float last) const { return first <= high[axis] && last >= low[axis]; }
};

ThreadShadows::ThreadShadows(ThreadScene& scene) : scene_(scene) {
  const int layers = scene.grid().layers;
  for (int i = 0; i < layers; ++i) layers_.push_back(scene.thread_layer(i, 1));
}

/// Tests thread `across` of a system between threads `along` and `along + 1` of the other.
void ThreadShadows::cast_span(Directions& open, std::vector<float>& clear, const ThreadGrid& g, const Around& around,
                              int system, int across, int along) {
  const int other = 1 - system;
  const Near &it = around.near(system, across), &first = around.near(other, along),
             &second = around.near(other, along + 1);
  if ((system == around.system && it.thread == around.thread) != around.only_it) return;
  const float aside = around.from[system] - it.centre, start = first.centre - around.from[other],
              step = second.centre - first.centre, lean = it.body.half_height;
  if (!around.crosses(system, -aside - it.wide, it.wide - aside)) return;
  if (!around.crosses(other, start - lean, start + step + lean)) return;
  const bool warp = system == 0;
  const glm::vec4 here = scene_.crossing_at(warp ? it.thread : first.thread, warp ? first.thread : it.thread);
  const glm::vec4 next = scene_.crossing_at(warp ? it.thread : second.thread, warp ? second.thread : it.thread);
  const glm::vec3 section = scene_.section_at(g, system, it.thread, it.body, first.thread),
                  next_section = scene_.section_at(g, system, it.thread, it.body, second.thread);
  Span span{{}, 1.0f / glm::vec2(section), {}, start, step, aside - section.z, section.z - next_section.z};
  span.thinner = 1.0f / glm::vec2(next_section) - span.thin;
  span.curve = warp ? cloth::thread_formulas::cubic_through(here.x, here.y, next.x, next.y, step)
                    : cloth::thread_formulas::cubic_through(here.z, here.w, next.z, next.w, step);
  const int pieces = around.only_it ? kOwnPieces : kPieces;
  const float per_piece = 1 / static_cast<float>(pieces);
  glm::vec3 low, high = cloth::thread_formulas::cubic_at(span.curve, 0);
  for (int k = 0; k < pieces; ++k) {
    low = high, high = cloth::thread_formulas::cubic_at(span.curve, static_cast<float>(k + 1) * per_piece * step);
    const glm::vec2 over = span.thin + span.thinner * ((static_cast<float>(k) + 0.5f) * per_piece);
    const float reach = 1 / over.y, from = start + static_cast<float>(k) * per_piece * step;
    const float nearest =
        around.down ? std::min(low.x, high.x) - reach - around.from.z : around.from.z - std::max(low.x, high.x) - reach;
    if (nearest > 0 || !around.crosses(other, from - reach, from + per_piece * step + reach)) continue;
    const Piece p = piece_of(span, k, pieces, around.from.z, low, high, over);
    occlude(p, open.size(), (warp ? open.x : open.y).data(), (warp ? open.y : open.x).data(), open.z.data(),
            clear.data());
  }
}

/// Moves directions that end before this ring of threads to `through`; `around` gets the bounds of the others.
void ThreadShadows::split_before(Directions& open, Directions& through, std::vector<float>& clear, Around& around,
                                 float depth, float away) {
  clear.assign(open.size(), 1.0f);
  around.low = around.high = glm::vec2(0);
  for (size_t k = 0; k < open.size(); ++k) {
    if (depth * open.slant[k] < away) {
      through.add_from(open, k), clear[k] = 0;
      continue;
    }
    const glm::vec2 end = glm::vec2(open.x[k], open.y[k]) * (depth / std::max(std::abs(open.z[k]), 1e-3f));
    around.low = glm::min(around.low, end), around.high = glm::max(around.high, end);
  }
  keep_unoccluded(open, clear);
}

void ThreadShadows::cast_layer(Directions& open, const ThreadGrid& g, Around& around) {
  const float depth = around.down ? around.from.z - g.bottom : g.top - around.from.z;
  std::vector<float> clear;
  Directions through;
  through.reserve(open.size());
  for (int s = 0; s < 2; ++s) around.fetch(scene_, g, s, 0);
  for (int ring = 0; ring <= kMaxRings && open.size() > 0; ++ring) {
    float away = 1e9f;  // distance from the point to the remaining threads
    for (int s = 0; s < 2; ++s) {
      for (const int turn : {-1, 1}) {
        around.fetch(scene_, g, s, turn * (ring + 1));
        const Near& next = around.near(s, turn * ring);
        away = std::min(away, static_cast<float>(turn) * (next.centre - around.from[s]) - next.wide);
      }
    }
    split_before(open, through, clear, around, depth, away);
    // Threads that cross the point's own first, since they are nearest.
    for (const int system : {1 - around.system, around.system}) {
      clear.assign(open.size(), 1.0f);
      for (int across = -ring; across <= ring; ++across) {
        const bool rim = std::abs(across) == ring;
        for (int along = -ring - 1; along <= ring; along += rim || along == ring ? 1 : 2 * ring + 1)
          cast_span(open, clear, g, around, system, across, along);
      }
      keep_unoccluded(open, clear);
    }
  }
  for (size_t k = 0; k < open.size(); ++k) through.add_from(open, k);
  open = std::move(through);
}

void ThreadShadows::cast(Directions& open, const glm::vec3& from, int system, int thread, bool only_it) {
  if (open.size() == 0) return;
  Around around;
  around.from = from, around.system = system, around.thread = thread, around.only_it = only_it;
  for (const ThreadGrid& g : layers_) {
    if (open.size() == 0) return;
    around.down = open.z.front() < 0;
    for (int s = 0; s < 2; ++s) {
      around.base[s] = std::floor(from[s] / g.period[s]) * g.period[s];
      around.middle[s] = scene_.thread_at(g, s, from[s] - around.base[s]) - g.first[s];
    }
    cast_layer(open, g, around);
  }
}

}  // namespace weftlight::light
