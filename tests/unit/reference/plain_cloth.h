#pragma once
// A plain weave for tests of fibres.

#include <utility>

#include "cloth/cloth.h"
#include "design/yarn.h"
#include "reference/fibre_patch.h"

namespace weftlight::reference {

/// Places in yarn_presets().
enum Preset : size_t { kCotton = 0, kLinen = 2, kSilk = 3, kWool = 4, kPolyester = 6 };

/// 16 x 16 threads that almost touch.
inline Cloth plain(design::Yarn yarn, cloth::Linear colour = {0.6f, 0.6f, 0.6f}) {
  Cloth cloth;
  const float d = yarn.diameter_mm, spacing = 1.15f * d;
  cloth.yarns = {std::move(yarn)};
  constexpr int kThreads = 16;
  for (int i = 0; i < kThreads; ++i)
    cloth.ends.push_back({(static_cast<float>(i) + 0.5f) * spacing, spacing, 1.1f * d, d / 1.1f, colour, 0, 0, d});
  cloth.picks = cloth.ends;
  cloth.width_mm = cloth.depth_mm = kThreads * spacing;
  cloth.up = draft::BitMatrix(kThreads, kThreads);
  for (int p = 0; p < kThreads; ++p)
    for (int e = 0; e < kThreads; ++e) cloth.up.set(p, e, (p + e) % 2);
  return cloth;
}

inline FibreOptions whole(const Cloth& cloth) {
  FibreOptions options;
  options.high_mm = {cloth.width_mm, cloth.depth_mm};
  return options;
}

}  // namespace weftlight::reference
