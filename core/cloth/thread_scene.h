#pragma once
// The threads of one period as shaders/threads.glsl reads them (bodies, bins, crossings), and that file's formulas on
// the CPU.

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "cloth/cloth.h"
#include "cloth/thread_texture.h"

namespace weftlight::cloth {

using draft::CellRect, draft::Face;

/// The data that the formulas fetch. Systems: 0 warp, 1 weft.
struct ThreadTables {
  std::vector<thread_formulas::ThreadHead> layers;  // at least one; the texel offsets of records are not set
  std::array<std::vector<glm::uvec4>, 2> bodies;    // packed; unpacked by record_body() of shaders/thread_records.glsl
  std::array<std::vector<int>, 2> first;            // first thread that reaches past each bin's start
};

/// Everything but the crossings. top_mm: bound of the threads' heights, for a single-layer cloth.
ThreadTables thread_tables(const Cloth& cloth, float top_mm);

/// Crossings of a window (indices wrap), row-major by pick: height and slope of the warp, then of the weft, on the
/// front. For several layers only the whole period, with 0 where threads of two layers cross.
std::vector<glm::vec4> thread_crossings(const Cloth& cloth, const CellRect& window);

/// How far washing moves the end and the pick of each crossing of a window sideways (mm, towards +across); empty where
/// it moves none.
std::vector<glm::vec2> thread_asides(const Cloth& cloth, const CellRect& window);

/// Bound of the heights of threads with these crossings, for a single-layer cloth.
float highest_thread(const Cloth& cloth, const std::vector<glm::vec4>& crossings);
/// A bound for any weave of these threads, without looking at a crossing.
float highest_thread(const Cloth& cloth);

namespace thread_formulas {

/// One face; the back is mirrored, in the front's (u, v).
class ThreadScene {
 public:
  explicit ThreadScene(const Cloth& cloth, Face face = Face::kFront);

  ThreadSection thread_body(int system, int thread) const {
    return record_body(tables_.bodies[static_cast<size_t>(system)][static_cast<size_t>(thread)]);
  }
  int thread_bin(int system, int bin) const {
    return tables_.first[static_cast<size_t>(system)][static_cast<size_t>(bin)];
  }
  vec4 crossing_at(int end, int pick) const {
    return crossings_[static_cast<size_t>(pick) * tables_.bodies[0].size() + static_cast<size_t>(end)];
  }
  vec2 aside_at(int end, int pick) const {
    return asides_[static_cast<size_t>(pick) * tables_.bodies[0].size() + static_cast<size_t>(end)];
  }
#define FORMULA
#include "shaders/threads.glsl"
#undef FORMULA
  using ThreadGrid = thread_formulas::ThreadGrid;
  ThreadGrid thread_layer(int i, float side) const { return grid_of(tables_.layers[static_cast<size_t>(i)], side); }
  ThreadGrid grid() const { return thread_layer(0, side_); }

 private:
  std::vector<glm::vec4> crossings_;
  std::vector<glm::vec2> asides_;
  ThreadTables tables_;
  float side_;
};

}  // namespace thread_formulas

using thread_formulas::ThreadScene;

}  // namespace weftlight::cloth
