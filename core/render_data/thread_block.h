#pragma once
// The threads of a cloth, as method `yarn` fetches them (shaders/thread_fetch.glsl).

#include <array>
#include <compare>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "cloth/cloth.h"
#include "render_data/packed_maps.h"

namespace weftlight::render_data {

using cloth::Cloth;
using draft::BitMatrix, draft::CellRect;

/// The crossings of larger drafts (128 MB) are not stored: the shader computes them from the drawdown. That takes 3
/// bits a crossing instead of 64, and more time for each sample.
inline constexpr int64_t kMaxCrossings = int64_t{1} << 24;

/// Texels of shaders/thread_records.glsl. `top_mm`: bound of the crossings, kept by the caller, since an edit knows
/// only some of them.
std::vector<glm::uvec4> thread_records(const Cloth& front, float top_mm);

/// Properties of a cloth that let its shader omit code (shaders/threads.glsl).
struct ThreadKind {
  bool even = false;  // all threads of a system have the same spacing
  bool one_layer = false;
  bool smooth = false;    // no thread is uneven along its length
  bool straight = false;  // washing moves no thread sideways
  bool closed = false;    // threads of a system touch everywhere: nothing is seen through the cloth
  bool dyed = false;      // the colour of some thread changes along it
  bool computed = false;  // its crossings are computed from the drawdown
  auto operator<=>(const ThreadKind&) const = default;
};
/// From the texels of thread_records(); those do not tell `computed`.
ThreadKind thread_kind(const std::vector<glm::uvec4>& records);

/// Row-major, a row a pick.
std::vector<HalfCrossing> packed_crossings(const std::vector<glm::vec4>& crossings);
/// The offsets of the threads at the crossings of a window as they are uploaded; empty where none is moved.
std::vector<HalfCrossing> packed_asides(const Cloth& cloth, const CellRect& window);

/// The drawdown for shaders/crossings.glsl: for each pick and then for each end a row of strips of STRIP_CELLS cells
/// along it, each with the STRIP_MARGIN cells on either side, which wrap; the first in the lowest bit, 1 where the warp
/// is above. The cloth has one layer.
std::vector<uint32_t> cell_strips(const BitMatrix& up);
/// Those of the picks and of the ends of these cells, each with its place among all.
std::array<StripPatch, 2> cell_strips(const BitMatrix& up, const CellRect& cells);

/// Crossings that a change of the cells in `dirty` can affect, cut to the period.
CellRect touched_crossings(const Cloth& cloth, const CellRect& dirty);

}  // namespace weftlight::render_data
