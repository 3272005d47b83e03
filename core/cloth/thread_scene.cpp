#include "cloth/thread_scene.h"

#include <algorithm>
#include <cmath>

#include "cloth/centre_line.h"

namespace weftlight::cloth {
namespace {

constexpr int kBinsAThread = 4;

std::vector<glm::vec4> bodies_of(const std::vector<ThreadBody>& threads) {
  std::vector<glm::vec4> out;
  out.reserve(threads.size());
  for (const ThreadBody& t : threads)
    out.push_back({t.centre_mm, 0.5f * t.spacing_mm, 0.5f * t.width_mm, 0.5f * t.height_mm});
  return out;
}

std::vector<int> bins_of(const std::vector<glm::vec4>& bodies, float period) {
  const size_t count = bodies.size() * kBinsAThread;
  std::vector<int> first(count);
  size_t thread = 0;
  for (size_t bin = 0; bin < count; ++bin) {
    const float start = period * static_cast<float>(bin) / static_cast<float>(count);
    while (thread + 1 < bodies.size() && bodies[thread].x + bodies[thread].y <= start) ++thread;
    first[bin] = static_cast<int>(thread);
  }
  return first;
}

/// Threads that all have the same room can be found by a division.
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

/// Place of thread i of an endless row.
float place_of(const std::vector<ThreadBody>& threads, float period, int i) {
  const int n = static_cast<int>(threads.size());
  const int turn = i >= 0 ? i / n : -((n - 1 - i) / n);
  return threads[static_cast<size_t>(i - turn * n)].centre_mm + static_cast<float>(turn) * period;
}

std::vector<float> places_of(const std::vector<ThreadBody>& threads, float period, int from, int to) {
  std::vector<float> out;
  for (int i = from; i < to; ++i) out.push_back(place_of(threads, period, i));
  return out;
}

}  // namespace

std::vector<glm::vec4> thread_crossings(const Cloth& cloth, const CellRect& w) {
  std::vector<glm::vec4> out;
  if (cloth.ends.empty() || cloth.picks.empty() || w.empty()) return out;
  const CentreLines lines = centre_lines(cloth, {w.end0 - 1, w.end1 + 1, w.pick0 - 1, w.pick1 + 1});
  const std::vector<float> x = places_of(cloth.ends, cloth.width_mm, w.end0 - 1, w.end1 + 1);
  const std::vector<float> y = places_of(cloth.picks, cloth.depth_mm, w.pick0 - 1, w.pick1 + 1);
  out.reserve(static_cast<size_t>(w.end1 - w.end0) * static_cast<size_t>(w.pick1 - w.pick0));
  for (int p = w.pick0; p < w.pick1; ++p) {
    const size_t j = static_cast<size_t>(p - w.pick0);
    const float down = std::max(y[j + 2] - y[j], 2e-6f);
    for (int e = w.end0; e < w.end1; ++e) {
      const size_t i = static_cast<size_t>(e - w.end0);
      const float across = std::max(x[i + 2] - x[i], 2e-6f);
      out.push_back({lines.at(System::kWarp, e, p),
                     centre_slope(lines.at(System::kWarp, e, p - 1), lines.at(System::kWarp, e, p + 1), down),
                     lines.at(System::kWeft, e, p),
                     centre_slope(lines.at(System::kWeft, e - 1, p), lines.at(System::kWeft, e + 1, p), across)});
    }
  }
  return out;
}

float highest_thread(const Cloth& cloth, const std::vector<glm::vec4>& crossings) {
  float end = 0, pick = 0, most = 0;
  for (const ThreadBody& t : cloth.ends) end = std::max(end, 0.5f * t.height_mm);
  for (const ThreadBody& t : cloth.picks) pick = std::max(pick, 0.5f * t.height_mm);
  const float between_ends = widest_room(cloth.ends), between_picks = widest_room(cloth.picks);
  // Between crossings a cubic rises above them by a quarter of its slopes' rise at the most.
  for (const glm::vec4& c : crossings) {
    const float warp = std::abs(c.x) + end * std::sqrt(1 + c.y * c.y) + 0.25f * std::abs(c.y) * between_picks;
    const float weft = std::abs(c.z) + pick * std::sqrt(1 + c.w * c.w) + 0.25f * std::abs(c.w) * between_ends;
    most = std::max(most, std::max(warp, weft));
  }
  return std::clamp(most, 1e-5f, std::max(1e-5f, 3 * (end + pick)));
}

ThreadTables thread_tables(const Cloth& cloth) {
  ThreadTables t;
  t.count = {static_cast<int>(cloth.ends.size()), static_cast<int>(cloth.picks.size())};
  t.period = {cloth.width_mm, cloth.depth_mm};
  t.bodies = {bodies_of(cloth.ends), bodies_of(cloth.picks)};
  t.first = {bins_of(t.bodies[0], t.period.x), bins_of(t.bodies[1], t.period.y)};
  t.bins = t.count * kBinsAThread;
  if (cloth.ends.empty() || cloth.picks.empty()) return t;
  t.even = {even_room(cloth.ends), even_room(cloth.picks)};
  t.spacing = 0.5f * (t.period.x / static_cast<float>(t.count.x) + t.period.y / static_cast<float>(t.count.y));
  return t;
}

thread_formulas::ThreadScene::ThreadScene(const Cloth& cloth, Face face)
    : tables_(thread_tables(cloth)),
      crossings_(thread_crossings(cloth, {0, tables_.count.x, 0, tables_.count.y})),
      side_(face == Face::kFront ? 1.0f : -1.0f) {
  tables_.top = highest_thread(cloth, crossings_);
}

}  // namespace weftlight::cloth
