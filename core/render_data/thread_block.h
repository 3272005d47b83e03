#pragma once
// The threads of a cloth, one by one, as rung `yarn` fetches them (shaders/thread_fetch.glsl).

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "cloth/cloth.h"
#include "render_data/names.h"
#include "render_data/packed_maps.h"

namespace weftlight::render_data {

/// Drafts with more crossings than this are not drawn thread by thread: 128 MB.
inline constexpr int64_t kMaxCrossings = int64_t{1} << 24;

/// Texels of shaders/thread_records.glsl. `top_mm`: the crossings' bound, kept by the caller, since an edit knows a few
/// of them alone.
std::vector<glm::uvec4> thread_records(const Cloth& front, float top_mm);

/// What of a cloth its program can leave out (shaders/threads.glsl).
struct ThreadKind {
  bool even = false;  // the rooms of each system's threads are alike
  bool one_layer = false;
  bool smooth = false;  // no thread swells along its length
};
/// Of the texels of thread_records().
ThreadKind thread_kind(const std::vector<glm::uvec4>& records);

/// A row a pick.
std::vector<HalfCrossing> packed_crossings(const std::vector<glm::vec4>& crossings);

/// Crossings that a change of the cells in `dirty` can touch, cut to the period.
CellRect touched_crossings(const Cloth& cloth, const CellRect& dirty);

}  // namespace weftlight::render_data
