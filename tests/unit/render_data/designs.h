#pragma once
// Small designs and meshes for the tests of render data and renderer.

#include "design/edits.h"
#include "drape/mesh.h"

namespace weftlight::render_data {

using design::Design, design::Twist;
using draft::Draft, draft::Rgb, draft::ShedControl, draft::blank_draft;
using drape::Mesh, drape::Vec2;

/// Ends x picks, one shaft an end of the repeat, the warp up where (pick + end) % repeat < up.
inline Design twill(int repeat, int up, Rgb warp, Rgb weft) {
  Design design;
  const int threads = repeat * 2;
  design.draft = blank_draft(threads, threads, repeat, repeat);
  Draft& d = design.draft;
  d.shed_control = ShedControl::kLiftplan;
  d.palette = {warp, weft};
  for (int i = 0; i < threads; ++i) {
    d.threading.set(i, i % repeat, true);
    d.warp.color[static_cast<size_t>(i)] = 0;
    d.weft.color[static_cast<size_t>(i)] = 1;
    for (int s = 0; s < repeat; ++s) d.liftplan.set(i, s, (i + s) % repeat < up);
  }
  design.yarns[0].twist = Twist::kNone;
  design.scene.mesh.clear();  // the tests bring their own
  return design;
}

/// A square that faces +z, its uv starting at `uv0`.
inline Mesh square(float side_mm, Vec2 uv0 = {0, 0}) {
  Mesh mesh;
  constexpr int kSteps = 8;
  for (int y = 0; y <= kSteps; ++y) {
    for (int x = 0; x <= kSteps; ++x) {
      const float u = side_mm * static_cast<float>(x) / kSteps, v = side_mm * static_cast<float>(y) / kSteps;
      mesh.position_mm.push_back({u - side_mm / 2, v, 0});
      mesh.normal.push_back({0, 0, 1});
      mesh.tangent.push_back({1, 0, 0});
      mesh.uv_mm.push_back({u + uv0[0], v + uv0[1]});
    }
  }
  for (int y = 0; y < kSteps; ++y) {
    for (int x = 0; x < kSteps; ++x) {
      const uint32_t a = static_cast<uint32_t>(y * (kSteps + 1) + x), b = a + kSteps + 1;
      mesh.index.insert(mesh.index.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  }
  return mesh;
}

}  // namespace weftlight::render_data
