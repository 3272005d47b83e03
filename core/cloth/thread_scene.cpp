#include "cloth/thread_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cloth/centre_line.h"
#include "cloth/layers.h"
#include "cloth/thickness.h"
#include "cloth/washed_aside.h"

namespace weftlight::cloth {

using draft::System;

namespace {

constexpr int kBinsAThread = 4;  // of shaders/threads.glsl

std::vector<glm::uvec4> bodies_of(const std::vector<ThreadBody>& threads, float length_mm) {
  std::vector<glm::uvec4> out;
  out.reserve(threads.size());
  for (const ThreadBody& t : threads) out.push_back(thread_formulas::pack_section(thread_section(t, length_mm)));
  return out;
}

/// Adds the bins of the threads [from, to), which fill the period.
void add_bins(std::vector<int>& first, const std::vector<ThreadBody>& threads, size_t from, size_t to, float period) {
  const size_t count = (to - from) * kBinsAThread;
  size_t thread = from;
  for (size_t bin = 0; bin < count; ++bin) {
    const float start = period * static_cast<float>(bin) / static_cast<float>(count);
    while (thread + 1 < to && threads[thread].centre_mm + 0.5f * threads[thread].spacing_mm <= start) ++thread;
    first.push_back(static_cast<int>(thread));
  }
}

/// Common spacing of all threads, which can then be found by a division; 0 if they differ.
float even_room(const std::vector<ThreadBody>& threads) {
  const float room = threads.front().spacing_mm;
  const bool even =
      std::all_of(threads.begin(), threads.end(), [&](const ThreadBody& t) { return t.spacing_mm == room; });
  return even ? room : 0;
}

float widest_room(const std::vector<ThreadBody>& threads) {
  float most = 0;
  for (const ThreadBody& t : threads) most = std::max(most, t.spacing_mm);
  return most;
}

/// Centre of thread i of the endless periodic row.
float centre_of(const std::vector<ThreadBody>& threads, float period, int i) {
  const int n = static_cast<int>(threads.size());
  const int turn = i >= 0 ? i / n : -((n - 1 - i) / n);
  return threads[static_cast<size_t>(i - turn * n)].centre_mm + static_cast<float>(turn) * period;
}

std::vector<float> centres_of(const std::vector<ThreadBody>& threads, float period, int from, int to) {
  std::vector<float> out;
  for (int i = from; i < to; ++i) out.push_back(centre_of(threads, period, i));
  return out;
}

}  // namespace

namespace {

/// Crossings of each layer, at their indices in the whole cloth.
std::vector<glm::vec4> layered_crossings(const Cloth& cloth) {
  const size_t ends = cloth.ends.size();
  std::vector<glm::vec4> out(ends * cloth.picks.size(), glm::vec4(0));
  for (int i = 0; i < layer_count(cloth); ++i) {
    const ClothLayer& l = cloth.layers[static_cast<size_t>(i)];
    const std::vector<glm::vec4> own = thread_crossings(one_layer(cloth, i), {0, l.ends, 0, l.picks});
    for (int p = 0; p < l.picks; ++p)
      std::copy_n(
          own.begin() + static_cast<std::ptrdiff_t>(p) * l.ends, l.ends,
          out.begin() + static_cast<std::ptrdiff_t>(static_cast<size_t>(l.first_pick + p) * ends) + l.first_end);
  }
  return out;
}

}  // namespace

std::vector<glm::vec4> thread_crossings(const Cloth& cloth, const CellRect& w) {
  std::vector<glm::vec4> out;
  if (cloth.ends.empty() || cloth.picks.empty() || w.empty()) return out;
  if (!cloth.layers.empty()) return layered_crossings(cloth);
  const CentreLines lines = centre_lines(cloth, {w.end0 - 1, w.end1 + 1, w.pick0 - 1, w.pick1 + 1});
  const std::vector<float> x = centres_of(cloth.ends, cloth.width_mm, w.end0 - 1, w.end1 + 1);
  const std::vector<float> y = centres_of(cloth.picks, cloth.depth_mm, w.pick0 - 1, w.pick1 + 1);
  out.reserve(static_cast<size_t>(w.end1 - w.end0) * static_cast<size_t>(w.pick1 - w.pick0));
  for (int p = w.pick0; p < w.pick1; ++p) {
    const size_t j = static_cast<size_t>(p - w.pick0);
    for (int e = w.end0; e < w.end1; ++e) {
      const size_t i = static_cast<size_t>(e - w.end0);
      const float more_down = aside_at(cloth, System::kWeft, p + 1, e) - aside_at(cloth, System::kWeft, p - 1, e),
                  more_across = aside_at(cloth, System::kWarp, e + 1, p) - aside_at(cloth, System::kWarp, e - 1, p);
      const float down = std::max(y[j + 2] - y[j] + more_down, thread_formulas::kMinStep_mm);
      const float across = std::max(x[i + 2] - x[i] + more_across, thread_formulas::kMinStep_mm);
      out.push_back({lines.at(System::kWarp, e, p),
                     centre_slope(lines.at(System::kWarp, e, p - 1), lines.at(System::kWarp, e, p + 1), down),
                     lines.at(System::kWeft, e, p),
                     centre_slope(lines.at(System::kWeft, e - 1, p), lines.at(System::kWeft, e + 1, p), across)});
    }
  }
  return out;
}

std::vector<glm::vec2> thread_asides(const Cloth& cloth, const CellRect& w) {
  std::vector<glm::vec2> out;
  if (cloth.warp_aside_mm.empty()) return out;
  for (int p = w.pick0; p < w.pick1; ++p)
    for (int e = w.end0; e < w.end1; ++e)
      out.push_back({aside_at(cloth, System::kWarp, e, p), aside_at(cloth, System::kWeft, p, e)});
  return out;
}

namespace {

/// Lowest and highest level that threads with these crossings reach.
glm::vec2 span_of(const Cloth& cloth, const std::vector<glm::vec4>& crossings) {
  const float end = tallest_half(cloth, System::kWarp), pick = tallest_half(cloth, System::kWeft);
  const float between_ends = widest_room(cloth.ends), between_picks = widest_room(cloth.picks);
  glm::vec2 span(std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest());
  // Between crossings a cubic rises above them by a quarter of its slopes' rise at the most.
  for (const glm::vec4& c : crossings) {
    const float warp = end * std::sqrt(1 + c.y * c.y) + 0.25f * std::abs(c.y) * between_picks;
    const float weft = pick * std::sqrt(1 + c.w * c.w) + 0.25f * std::abs(c.w) * between_ends;
    span.x = std::min({span.x, c.x - warp, c.z - weft}), span.y = std::max({span.y, c.x + warp, c.z + weft});
  }
  return span;
}

}  // namespace

float highest_thread(const Cloth& cloth, const std::vector<glm::vec4>& crossings) {
  const float end = tallest_half(cloth, System::kWarp), pick = tallest_half(cloth, System::kWeft);
  float most = 0;
  const float between_ends = widest_room(cloth.ends), between_picks = widest_room(cloth.picks);
  // Between crossings a cubic rises above them by a quarter of its slopes' rise at the most.
  for (const glm::vec4& c : crossings) {
    const float warp = std::abs(c.x) + end * std::sqrt(1 + c.y * c.y) + 0.25f * std::abs(c.y) * between_picks;
    const float weft = std::abs(c.z) + pick * std::sqrt(1 + c.w * c.w) + 0.25f * std::abs(c.w) * between_ends;
    most = std::max(most, std::max(warp, weft));
  }
  float level = 0;
  for (const float mm : cloth.warp_level_mm) level = std::max(level, std::abs(mm));
  return std::clamp(most, 1e-5f, std::max(1e-5f, 3 * (end + pick) + level));
}

namespace {

/// Of the threads of one system.
struct Extremes {
  float least_stiff = std::numeric_limits<float>::max(), most_stiff = 0;
  float rise = 0;  // of the longest float
  float least_room = std::numeric_limits<float>::max();
};

/// span_mm: mean spacing of the threads that they cross.
Extremes extremes_of(const std::vector<ThreadBody>& threads, float span_mm) {
  Extremes x;
  for (const ThreadBody& t : threads) {
    const float stiff = thread_formulas::bending_stiffness(t.width_mm, t.height_mm, span_mm);
    x.least_stiff = std::min(x.least_stiff, stiff), x.most_stiff = std::max(x.most_stiff, stiff);
    x.rise = std::max(x.rise, thread_formulas::longest_rise(t.width_mm, t.height_mm, t.spacing_mm));
    x.least_room = std::min(x.least_room, t.spacing_mm);
  }
  return x;
}

/// Above a crossing of this height, if the ones before and after are as far below; `between`: the widest space there.
float top_above(float height, float half, float least_room, float between) {
  const float slope = centre_slope(-height, height, std::max(2 * least_room, thread_formulas::kMinStep_mm));
  return height + half * std::sqrt(1 + slope * slope) + 0.25f * slope * between;
}

}  // namespace

float highest_thread(const Cloth& cloth) {
  if (cloth.ends.empty() || cloth.picks.empty()) return 1e-5f;
  const float end = tallest_half(cloth, System::kWarp), pick = tallest_half(cloth, System::kWeft);
  const Extremes warp = extremes_of(cloth.ends, cloth.depth_mm / static_cast<float>(cloth.picks.size())),
                 weft = extremes_of(cloth.picks, cloth.width_mm / static_cast<float>(cloth.ends.size()));
  using thread_formulas::crimp_fraction;
  const float of_warp = crimp_fraction(warp.least_stiff, weft.most_stiff) * (end + pick) + warp.rise;
  const float of_weft = (1 - crimp_fraction(warp.most_stiff, weft.least_stiff)) * (end + pick) + weft.rise;
  const float most = std::max(top_above(of_warp, end, weft.least_room, widest_room(cloth.picks)),
                              top_above(of_weft, pick, warp.least_room, widest_room(cloth.ends)));
  return std::clamp(most, 1e-5f, std::max(1e-5f, 3 * (end + pick)));
}

namespace {

thread_formulas::ThreadHead head_of(const Cloth& one, int layers) {
  thread_formulas::ThreadHead h{};
  h.layers = layers;
  h.count = {static_cast<int>(one.ends.size()), static_cast<int>(one.picks.size())};
  h.first = {one.first_end, one.first_pick};
  h.period = {one.width_mm, one.depth_mm};
  if (one.ends.empty() || one.picks.empty()) return h;
  h.even = {even_room(one.ends), even_room(one.picks)};
  h.aside = furthest_aside(one);
  h.spacing = 0.5f * (h.period.x / static_cast<float>(h.count.x) + h.period.y / static_cast<float>(h.count.y));
  return h;
}

/// Range of heights of a layer: rays look for it only there.
void set_span(thread_formulas::ThreadHead& h, Cloth one) {
  const CellRect all{0, h.count.x, 0, h.count.y};
  const glm::vec2 span = span_of(one, thread_crossings(one, all));
  h.bottom = span.x, h.top = span.y;
  one.warp_level_mm.clear(), one.weft_level_mm.clear();
  h.reach = highest_thread(one, thread_crossings(one, all));
}

}  // namespace

ThreadTables thread_tables(const Cloth& cloth, float top_mm) {
  ThreadTables t;
  t.bodies = {bodies_of(cloth.ends, cloth.depth_mm), bodies_of(cloth.picks, cloth.width_mm)};
  const int layers = layer_count(cloth);
  for (int i = 0; i < layers; ++i) {
    const ClothLayer l = cloth.layers.empty() ? ClothLayer{0, static_cast<int>(cloth.ends.size()), 0,
                                                           static_cast<int>(cloth.picks.size())}
                                              : cloth.layers[static_cast<size_t>(i)];
    add_bins(t.first[0], cloth.ends, static_cast<size_t>(l.first_end), static_cast<size_t>(l.first_end + l.ends),
             cloth.width_mm);
    add_bins(t.first[1], cloth.picks, static_cast<size_t>(l.first_pick), static_cast<size_t>(l.first_pick + l.picks),
             cloth.depth_mm);
    if (layers > 1) {
      Cloth one = one_layer(cloth, i);
      t.layers.push_back(head_of(one, layers));
      set_span(t.layers.back(), std::move(one));
    } else {
      t.layers.push_back(head_of(cloth, 1));
      t.layers.back().top = t.layers.back().reach = top_mm, t.layers.back().bottom = -top_mm;
    }
  }
  return t;
}

namespace {

float top_of(const Cloth& cloth, const std::vector<glm::vec4>& crossings) {
  return cloth.layers.empty() ? highest_thread(cloth, crossings) : 0.0f;
}

}  // namespace

thread_formulas::ThreadScene::ThreadScene(const Cloth& cloth, Face face)
    : crossings_(
          thread_crossings(cloth, {0, static_cast<int>(cloth.ends.size()), 0, static_cast<int>(cloth.picks.size())})),
      asides_(thread_asides(cloth, {0, static_cast<int>(cloth.ends.size()), 0, static_cast<int>(cloth.picks.size())})),
      tables_(thread_tables(cloth, top_of(cloth, crossings_))),
      side_(face == Face::kFront ? 1.0f : -1.0f) {}

}  // namespace weftlight::cloth
