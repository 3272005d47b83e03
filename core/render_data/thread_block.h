#pragma once
// The threads of a cloth, as method `yarn` fetches them (shaders/thread_fetch.glsl).

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "cloth/cloth.h"
#include "render_data/packed_maps.h"

namespace weftlight::render_data {

using cloth::Cloth;
using draft::CellRect;

/// Drafts with more crossings (128 MB) are not drawn thread by thread.
inline constexpr int64_t kMaxCrossings = int64_t{1} << 24;

/// Texels of shaders/thread_records.glsl. `top_mm`: bound of the crossings, kept by the caller, since an edit knows
/// only some of them.
std::vector<glm::uvec4> thread_records(const Cloth& front, float top_mm);

/// Properties of a cloth that let its shader omit code (shaders/threads.glsl).
struct ThreadKind {
  bool even = false;  // all threads of a system have the same spacing
  bool one_layer = false;
  bool smooth = false;  // no thread is uneven along its length
};
/// From the texels of thread_records().
ThreadKind thread_kind(const std::vector<glm::uvec4>& records);

/// Row-major, a row a pick.
std::vector<HalfCrossing> packed_crossings(const std::vector<glm::vec4>& crossings);

/// Crossings that a change of the cells in `dirty` can affect, cut to the period.
CellRect touched_crossings(const Cloth& cloth, const CellRect& dirty);

}  // namespace weftlight::render_data
