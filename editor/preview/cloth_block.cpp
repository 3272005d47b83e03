#include "preview/cloth_block.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace weftlight {
namespace {

/// The lobes of a system: means over its threads.
interop::SystemData mean_lobes(const Cloth& cloth, const std::vector<ThreadBody>& threads) {
  interop::SystemData s{};
  const float share = threads.empty() ? 0 : 1.0f / static_cast<float>(threads.size());
  for (const ThreadBody& thread : threads) {
    const Lobes& l = cloth.yarns[static_cast<size_t>(thread.yarn)].lobes;
    const Linear tint = linear_from_srgb(l.specular_tint);
    const float f = (l.ior - 1) / (l.ior + 1);
    const std::array<float, 16> values{l.along_width, l.across_width, 0, l.fuzz_width, l.specular, l.body, l.fuzz,
                                       l.transmission, tint.r, tint.g, tint.b, l.metallic ? 1.0f : 0.0f, f * f, 0, 0, 0};
    float* to = s.widths.data();
    for (size_t i = 0; i < values.size(); ++i) to[i] += values[i] * share;
  }
  return s;
}

/// Mean coverage and the mean angle of the fibres to the thread's axis, from a sparse grid of texels.
void add_means(interop::SystemData& s, const Maps& maps, int system) {
  const int step_x = std::max(1, maps.coverage.width / 256), step_y = std::max(1, maps.coverage.height / 256);
  double covered = 0, across = 0, along = 0;
  int count = 0;
  for (int y = 0; y < maps.coverage.height; y += step_y) {
    for (int x = 0; x < maps.coverage.width; x += step_x, ++count) {
      if ((maps.system.at(x, y) != 0) != (system != 0)) continue;
      const double w = static_cast<double>(maps.coverage.at(x, y));
      const Direction& t = maps.tangent.at(x, y);
      // The angle is from the axis, towards +x for an end and towards +y for a pick.
      const float a = system ? t.x : t.y, c = system ? t.y : t.x;
      const float sign = a < 0 ? -1.0f : 1.0f;
      covered += w, along += w * static_cast<double>(a * sign), across += w * static_cast<double>(c * sign);
    }
  }
  s.widths[2] = along > 0 ? static_cast<float>(across / along) : 0;
  s.extra[1] = count ? static_cast<float>(covered / count) : 0;
}

}  // namespace

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
      add_means(s, faces[face]->maps, system);
    }
  }
  data.size = {front.cloth.width_mm, front.cloth.depth_mm, mean_spacing_mm(front.cloth),
               static_cast<float>(front.maps.azimuths)};
  std::vector<float> block(sizeof data / sizeof(float));
  std::memcpy(block.data(), &data, sizeof data);
  return block;
}

}  // namespace weftlight
