#include "upload/cloth_block.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace weftlight::upload {
namespace {

// Threads that cover this much touch: the slivers between them are dark, not windows.
constexpr float kClosed = 0.985f;

/// The lobes of a system: means over its threads.
interop::SystemData mean_lobes(const Cloth& cloth, const std::vector<ThreadBody>& threads) {
  interop::SystemData s{};
  const float share = threads.empty() ? 0 : 1.0f / static_cast<float>(threads.size());
  for (const ThreadBody& thread : threads) {
    const std::array<interop::vec4, 4> numbers = yarn_numbers(cloth.yarns[static_cast<size_t>(thread.yarn)].lobes);
    for (size_t i = 0; i < 4; ++i) {
      s.widths[i] += numbers[0][i] * share, s.weights[i] += numbers[1][i] * share;
      s.tint[i] += numbers[2][i] * share, s.extra[i] += numbers[3][i] * share;
    }
  }
  return s;
}

/// Sums over sparse texels of one system, one at a random place of each step: threads are as regular as a grid.
struct Sums {
  double covered = 0, across = 0, along = 0, height = 0;
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
      // The angle is from the axis, towards +x for an end and towards +y for a pick.
      const float a = system ? t.x : t.y, b = system ? t.y : t.x;
      const float sign = a < 0 ? -1.0f : 1.0f;
      sums.covered += w;
      sums.along += w * static_cast<double>(a * sign), sums.across += w * static_cast<double>(b * sign);
      sums.height += w * static_cast<double>(maps.height_mm.at(x, y));
      sums.color[0] += shade * static_cast<double>(c.r), sums.color[1] += shade * static_cast<double>(c.g);
      sums.color[2] += shade * static_cast<double>(c.b);
    }
  }
  return sums;
}

/// Mean coverage, colour and height of both systems, and the angle of their fibres to the thread's axis.
void add_means(interop::SystemData* systems, const Maps& maps, float spacing_mm) {
  const std::array<Sums, 2> sums{sum_system(maps, 0), sum_system(maps, 1)};
  std::array<double, 2> height{};
  for (size_t i = 0; i < 2; ++i) {
    const Sums& s = sums[i];
    const double weight = std::max(s.covered, 1e-9);
    height[i] = s.height / weight;
    systems[i].widths[2] = s.along > 0 ? static_cast<float>(s.across / s.along) : 0;
    systems[i].extra[1] = s.count ? static_cast<float>(s.covered / s.count) : 0;
    for (size_t c = 0; c < 3; ++c) systems[i].mean[c] = static_cast<float>(s.color[c] / weight);
  }
  const bool both = sums[0].covered > 0 && sums[1].covered > 0;
  const float lift = both ? static_cast<float>(height[0] - height[1]) / std::max(spacing_mm, 1e-3f) : 0;
  systems[0].extra[3] = lift, systems[1].extra[3] = -lift;
}

float mean_gap_mm(const std::vector<ThreadBody>& threads) {
  float sum = 0;
  for (const ThreadBody& t : threads) sum += std::max(0.0f, t.spacing_mm - t.width_mm);
  return threads.empty() ? 0 : sum / static_cast<float>(threads.size());
}

float mean_height_mm(const std::vector<ThreadBody>& threads) {
  float sum = 0;
  for (const ThreadBody& t : threads) sum += t.height_mm;
  return threads.empty() ? 0 : sum / static_cast<float>(threads.size());
}

}  // namespace

std::array<interop::vec4, 4> yarn_numbers(const Lobes& l) {
  const Linear tint = linear_from_srgb(l.specular_tint);
  const float f = (l.ior - 1) / (l.ior + 1);
  return {{{l.along_width, l.across_width, 0, l.fuzz_width},
           {l.specular, l.body, l.fuzz, l.transmission},
           {tint.r, tint.g, tint.b, l.metallic ? 1.0f : 0.0f},
           {f * f, 0, l.fuzz_width * l.fuzz_width, 0}}};
}

float mean_spacing_mm(const Cloth& cloth) {
  const float ends = static_cast<float>(std::max<size_t>(1, cloth.ends.size()));
  const float picks = static_cast<float>(std::max<size_t>(1, cloth.picks.size()));
  return 0.5f * (cloth.width_mm / ends + cloth.depth_mm / picks);
}

std::vector<float> cloth_block(const FaceInput& front, const FaceInput& back) {
  interop::ClothData data{};
  const FaceInput* faces[] = {&front, &back};
  for (size_t face = 0; face < 2; ++face) {
    for (int system = 0; system < 2; ++system) {
      const Cloth& cloth = faces[face]->cloth;
      interop::SystemData& s = data.systems[face * 2 + static_cast<size_t>(system)];
      s = mean_lobes(cloth, system ? cloth.picks : cloth.ends);
    }
    add_means(&data.systems[face * 2], faces[face]->maps, mean_spacing_mm(faces[face]->cloth));
  }
  data.size = {front.cloth.width_mm, front.cloth.depth_mm, mean_spacing_mm(front.cloth),
               static_cast<float>(front.maps.azimuths)};
  const float covered = data.systems[0].extra[1] + data.systems[1].extra[1];
  data.gaps = {mean_gap_mm(front.cloth.ends), mean_gap_mm(front.cloth.picks),
               0.5f * (mean_height_mm(front.cloth.ends) + mean_height_mm(front.cloth.picks)),
               covered < kClosed ? 1.0f : 0.0f};
  data.relief = {0, 0, 1, 1};
  std::vector<float> block(sizeof data / sizeof(float));
  std::memcpy(block.data(), &data, sizeof data);
  return block;
}

}  // namespace weftlight::upload
