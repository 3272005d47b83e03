#include "render_data/cloth_block.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "draft/bit_matrix.h"
#include "light/engine_texels.h"
#include "light/yarn_lobes.h"

namespace weftlight::render_data {

using cloth::BitMatrix, cloth::Direction, cloth::Linear, cloth::ThreadBody;
using light::mean_yarn, light::thread_spacing_mm;

namespace {

// Threads with this coverage count as touching: the slits between them are dark.
constexpr float kClosed = 0.985f;

/// Sums over sparse texels of one system, one at a random position of each step, since threads are as regular as a
/// grid.
struct Sums {
  double covered = 0, across = 0, along = 0;
  std::array<double, 3> color{};
  int count = 0;
};

Sums sum_system(const Maps& maps, int system) {
  const int step_x = std::max(1, maps.coverage.width / 256), step_y = std::max(1, maps.coverage.height / 256);
  Sums sums;
  uint32_t random = 1;
  for (int row = 0; row < maps.coverage.height / step_y; ++row) {
    for (int column = 0; column < maps.coverage.width / step_x; ++column, ++sums.count) {
      random = random * 1664525u + 1013904223u;
      const int x = column * step_x + static_cast<int>(random >> 24) % step_x;
      const int y = row * step_y + static_cast<int>(random >> 16 & 255u) % step_y;
      if ((maps.system.at(x, y) != 0) != (system != 0)) continue;
      const double w = static_cast<double>(maps.coverage.at(x, y));
      const Direction& t = maps.tangent.at(x, y);
      const Linear& c = maps.colour.at(x, y);
      const double shade = w * static_cast<double>(maps.groove.at(x, y));
      // The angle is measured from the axis, towards +x for an end and towards +y for a pick.
      const float a = system ? t.x : t.y, b = system ? t.y : t.x;
      const float sign = a < 0 ? -1.0f : 1.0f;
      sums.covered += w;
      sums.along += w * static_cast<double>(a * sign), sums.across += w * static_cast<double>(b * sign);
      sums.color[0] += shade * static_cast<double>(c.r), sums.color[1] += shade * static_cast<double>(c.g);
      sums.color[2] += shade * static_cast<double>(c.b);
    }
  }
  return sums;
}

/// Mean coverage and colour of both systems, and the angle of their fibres to the thread's axis.
void add_means(interop::SystemData* systems, const Maps& maps) {
  for (int system = 0; system < 2; ++system) {
    const Sums s = sum_system(maps, system);
    const double weight = std::max(s.covered, 1e-9);
    interop::SystemData& data = systems[system];
    data.fibre_tan = s.along > 0 ? static_cast<float>(s.across / s.along) : 0;
    data.coverage = s.count ? static_cast<float>(s.covered / s.count) : 0;
    for (int c = 0; c < 3; ++c) data.color[c] = static_cast<float>(s.color[static_cast<size_t>(c)] / weight);
  }
}

float mean_gap_mm(const std::vector<ThreadBody>& threads) {
  float sum = 0;
  for (const ThreadBody& t : threads) sum += std::max(0.0f, cloth::room_mm(t) - t.width_mm);
  return threads.empty() ? 0 : sum / static_cast<float>(threads.size());
}

float mean_height_mm(const std::vector<ThreadBody>& threads) {
  float sum = 0;
  for (const ThreadBody& t : threads) sum += t.height_mm;
  return threads.empty() ? 0 : sum / static_cast<float>(threads.size());
}

/// Whether every thread is as the one `period` threads on: of one yarn and colour, on top of the same threads.
bool repeats(const std::vector<ThreadBody>& threads, const BitMatrix& rows, int period) {
  for (int i = 0; i + period < rows.rows(); ++i) {
    const ThreadBody &one = threads[static_cast<size_t>(i)], &other = threads[static_cast<size_t>(i + period)];
    if (one.yarn != other.yarn || !(one.colour == other.colour)) return false;
    if (draft::differences(rows.row(i), rows.row(i + period)) > 0) return false;
  }
  return true;
}

/// By the first threads of a large cloth.
float half_period(const Cloth& cloth) {
  constexpr int kLongest = 32, kThreads = 256;
  BitMatrix picks = cloth.up;
  picks.resize(std::min(picks.rows(), kThreads), std::min(picks.cols(), kThreads));
  const BitMatrix ends = draft::transposed(picks);
  int period = 1;
  while (period < kLongest && !(repeats(cloth.picks, picks, period) && repeats(cloth.ends, ends, period))) ++period;
  return 0.5f * static_cast<float>(period);
}

}  // namespace

float mean_spacing_mm(const Cloth& cloth) { return thread_spacing_mm(cloth); }

interop::ClothData cloth_block(const FaceInput& front, const FaceInput& back) {
  interop::ClothData data{};
  const FaceInput* faces[] = {&front, &back};
  for (size_t face = 0; face < 2; ++face) {
    const Cloth& cloth = faces[face]->cloth;
    data.systems[face * 2].yarn = mean_yarn(cloth, cloth.ends);
    data.systems[face * 2 + 1].yarn = mean_yarn(cloth, cloth.picks);
    add_means(&data.systems[face * 2], faces[face]->maps);
  }
  data.width_mm = front.cloth.width_mm, data.depth_mm = front.cloth.depth_mm;
  data.spacing_mm = mean_spacing_mm(front.cloth), data.half_period = half_period(front.cloth);
  data.azimuths = static_cast<float>(front.maps.azimuths);
  data.gap_u_mm = mean_gap_mm(front.cloth.ends), data.gap_v_mm = mean_gap_mm(front.cloth.picks);
  data.rim_mm = 0.5f * (mean_height_mm(front.cloth.ends) + mean_height_mm(front.cloth.picks));
  data.open = data.systems[0].coverage + data.systems[1].coverage < kClosed ? 1.0f : 0.0f;
  data.front_sky = data.back_sky = 1;
  for (interop::EngineData& e : data.engine)
    e = {{1, 1, 1, 1}, {.04f, .04f, .04f, 0},        {1, 1, 1, 0.5f},
         {},           {{1, 0, 1, 0}, {1, 0, 1, 0}}, {{1, 1, 1, 0}, {1, 1, 1, 0}}};
  return data;
}

}  // namespace weftlight::render_data
