#pragma once
// The threads of a cloth as they are uploaded, read in C++ as shaders/thread_fetch.glsl reads them; and cloths to try
// it on.

#include <glm/gtc/packing.hpp>
#include <random>

#include "../render_data/designs.h"
#include "cloth/thread_scene.h"
#include "render_data/cloth_block.h"
#include "render_data/thread_block.h"

namespace weftlight::cloth::thread_formulas {

/// The threads as the GPU fetches them (shaders/thread_fetch.glsl), from what is uploaded.
class PackedThreads {
 public:
  PackedThreads(const render_data::PackedCloth& cloth, float side) : cloth_(cloth), head_(head_at(0)), side_(side) {}

  uvec4 texel(int i) const { return cloth_.lobes.threads[static_cast<size_t>(i)]; }
  ThreadHead head_at(int i) const {
    return thread_head(texel(i), texel(i + 1), texel(i + 2), texel(i + 3), texel(i + 4));
  }
  using ThreadGrid = thread_formulas::ThreadGrid;
  ThreadGrid thread_layer(int layer, float side) const { return grid_of(head_at(layer * THREAD_HEAD_TEXELS), side); }
  int record_at(int system, int thread) const { return head_.threads[system] + thread * THREAD_TEXELS; }
  ThreadSection thread_body(int system, int thread) const {
    return record_body(texel(record_at(system, thread) + THREAD_BODY));
  }
  uint thread_cells(int system, int thread, int crossing) const {
    const auto strips = [](int cells) { return (cells + STRIP_CELLS - 1) / STRIP_CELLS; };
    const int along = system == 1 ? cloth_.ends : cloth_.picks,
              before = system == 1 ? 0 : cloth_.picks * strips(cloth_.ends);
    const int i = before + thread * strips(along) + crossing / STRIP_CELLS;
    return cloth_.strips[static_cast<size_t>(i)] >> (crossing % STRIP_CELLS);
  }
  int thread_bin(int system, int bin) const { return static_cast<int>(texel(head_.bins[system] + bin / 4)[bin & 3]); }
  vec4 crossing_at(int end, int pick) {
    if (cloth_.crossings.empty()) return computed_crossing(grid_of(head_, 1), end, pick);
    const render_data::HalfCrossing& h = cloth_.crossings[static_cast<size_t>(pick * cloth_.ends + end)];
    return {glm::unpackHalf1x16(h[0]), glm::unpackHalf1x16(h[1]), glm::unpackHalf1x16(h[2]), glm::unpackHalf1x16(h[3])};
  }
  vec2 aside_at(int end, int pick) const {
    const render_data::HalfCrossing& h = cloth_.asides[static_cast<size_t>(pick * cloth_.ends + end)];
    return {glm::unpackHalf1x16(h[0]), glm::unpackHalf1x16(h[1])};
  }
#define FORMULA
#include "shaders/threads.glsl"
// These read the one before.
#include "shaders/crossings.glsl"
#include "shaders/irawan.glsl"
#undef FORMULA
  ThreadGrid grid() const { return grid_of(head_, side_); }
  vec4 look(int system, int thread) const { return record_color(texel(record_at(system, thread) + THREAD_COLOR)); }
  ThreadTexture pattern(int system, int thread) const {
    const int i = record_at(system, thread) + THREAD_PATTERN;
    return pattern_on(record_pattern(texel(i), texel(i + 1), texel(i + 2), texel(i + 3), texel(i + 4)), side_);
  }
  YarnData yarn(int yarn) const {
    const int i = head_.yarns + yarn * YARN_TEXELS;
    return record_yarn(texel(i), texel(i + 1), texel(i + 2), texel(i + 3));
  }

 private:
  const render_data::PackedCloth& cloth_;
  ThreadHead head_;
  float side_;
};

}  // namespace weftlight::cloth::thread_formulas

namespace weftlight::gl {

using cloth::Cloth, cloth::Period, cloth::ThreadBody, cloth::highest_thread, cloth::lay_out, cloth::thread_crossings;
using cloth::thread_formulas::PackedThreads;
using design::Design, design::Twist;
using draft::BitMatrix, draft::Face, draft::System, draft::drawdown;
using glm::vec2, glm::vec3, glm::vec4;
using render_data::PackedCloth, render_data::twill;

/// A 2/2 twill of two yarns, plied and twisted, with two thick ends: spacings differ, so that bins are used.
inline Cloth uneven_twill() {
  Design d = twill(4, 2, {0.7f, 0.2f, 0.1f}, {0.1f, 0.2f, 0.6f});
  d.yarns.push_back(d.yarns[0]);
  d.yarns[0].twist = Twist::kZ, d.yarns[0].plies = 2, d.yarns[0].unevenness = 50;
  d.yarns[1].twist = Twist::kS, d.yarns[1].lobes.along_width = 0.1f, d.yarns[1].lobes.fuzz = 0.3f;
  std::fill(d.draft.weft.yarn.begin(), d.draft.weft.yarn.end(), 1);
  d.draft.warp.spacing_mm.assign(d.draft.warp.color.size(), 0.6f);
  d.draft.warp.spacing_mm[1] = 1.7f;
  return lay_out(d, drawdown(d.draft), Face::kFront, Period::kWholeDraft);
}

/// Two layers of plain weave that change places after sixteen threads.
inline Cloth pockets() {
  Design d = twill(16, 8, {0.7f, 0.2f, 0.1f}, {0.1f, 0.2f, 0.6f});
  BitMatrix cells(d.draft.picks(), d.draft.ends());
  for (int p = 0; p < cells.rows(); ++p) {
    for (int e = 0; e < cells.cols(); ++e) {
      const bool first = e % 2 == 0, above = (e / 16 + p / 16) % 2 == 0;
      cells.set(p, e, first == (p % 2 == 0) ? (e / 2 + p / 2) % 2 == 0 : first == above);
    }
  }
  return lay_out(d, cells, Face::kFront, Period::kWholeDraft);
}

/// Mock leno, whose threads washing gathers in groups.
inline Cloth gathered() {
  Design d = twill(12, 4, {0.7f, 0.2f, 0.1f}, {0.1f, 0.2f, 0.6f});
  for (auto* threads : {&d.draft.warp, &d.draft.weft}) threads->spacing_mm.assign(threads->color.size(), 1.0f);
  BitMatrix cells(d.draft.picks(), d.draft.ends());
  for (int p = 0; p < cells.rows(); ++p) {
    for (int e = 0; e < cells.cols(); ++e) {
      const bool group = (e / 3 + p / 3) % 2 == 0;
      cells.set(p, e, p % 3 == 1 ? group : group == (e % 3 != 1));
    }
  }
  return lay_out(d, cells, Face::kFront, Period::kWholeDraft);
}

/// A warp satin of ends that are wider than their room.
inline Cloth jammed() {
  Design d = twill(8, 7, {0.7f, 0.2f, 0.1f}, {0.1f, 0.2f, 0.6f});
  d.draft.warp.spacing_mm.assign(d.draft.warp.color.size(), 0.7f * d.yarns[0].diameter_mm);
  d.draft.weft.spacing_mm.assign(d.draft.weft.color.size(), 1.5f * d.yarns[0].diameter_mm);
  return lay_out(d, drawdown(d.draft), Face::kFront, Period::kWholeDraft);
}

inline PackedCloth packed(const Cloth& cloth) {
  PackedCloth p;
  p.width_mm = cloth.width_mm, p.depth_mm = cloth.depth_mm, p.mean_spacing_mm = render_data::mean_spacing_mm(cloth);
  p.ends = static_cast<int>(cloth.ends.size()), p.picks = static_cast<int>(cloth.picks.size());
  const std::vector<vec4> crossings = thread_crossings(cloth, {0, p.ends, 0, p.picks});
  p.crossings = render_data::packed_crossings(crossings);
  p.asides = render_data::packed_asides(cloth, {0, p.ends, 0, p.picks});
  p.lobes.threads = render_data::thread_records(cloth, cloth.layers.empty() ? highest_thread(cloth, crossings) : 0);
  return p;
}

/// The same without stored crossings, as of a draft that has too many of them.
inline PackedCloth in_strips(const Cloth& cloth) {
  PackedCloth p = packed(cloth);
  p.crossings = {};
  p.strips = render_data::cell_strips(cloth.up);
  return p;
}

/// Threads of two thicknesses, some uneven, that cross at random.
inline Cloth unordered(int ends, int picks) {
  Design d = twill(4, 2, {0.7f, 0.2f, 0.1f}, {0.1f, 0.2f, 0.6f});
  d.draft = draft::blank_draft(ends, picks, 2, 2);
  d.yarns.push_back(d.yarns[0]);
  d.yarns[1].unevenness = 40;
  d.plan.warp_shrinkage = d.plan.weft_shrinkage = 0;  // drafts of so many crossings have no relief
  std::mt19937 rng(static_cast<unsigned>(ends * 1000 + picks));
  for (auto* threads : {&d.draft.warp, &d.draft.weft}) {
    threads->spacing_mm.assign(threads->color.size(), 0.7f);
    for (size_t i = 0; i < threads->color.size(); ++i) {
      threads->yarn[i] = rng() % 3 == 0;
      if (i % 5 == 0) threads->spacing_mm[i] = 1.1f;
    }
  }
  BitMatrix cells(picks, ends);
  for (int p = 0; p < picks; ++p)
    for (int e = 0; e < ends; ++e) cells.set(p, e, rng() % 2 == 0);
  Cloth cloth = lay_out(d, cells, Face::kFront, Period::kWholeDraft);
  cloth.warp_aside_mm.clear(), cloth.weft_aside_mm.clear();  // nor does washing move their threads
  return cloth;
}

}  // namespace weftlight::gl
