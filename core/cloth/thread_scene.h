#pragma once
// The threads of one period as shaders/threads.glsl reads them: bodies, bins and crossings; and that file's
// formulas on them, for whoever wants to ask the cloth itself on the CPU.

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "cloth/cloth.h"
#include "cloth/names.h"
#include "cloth/thread_texture.h"

namespace weftlight::cloth {

/// What the formulas fetch. Systems: 0 warp, 1 weft.
struct ThreadTables {
  glm::ivec2 count{0}, bins{0};
  glm::vec2 period{0};                           // mm
  float spacing = 0;                             // mean of both systems, mm
  float top = 0;                                 // no thread is higher, mm
  glm::vec2 even{0};                             // the room of each thread where a system's are alike, else 0
  std::array<std::vector<glm::vec4>, 2> bodies;  // centre, half the room, half width, half height, mm
  std::array<std::vector<int>, 2> first;         // of the threads that reach past a bin's start
};

/// All but the crossings; `top` from the crossings of the whole period.
ThreadTables thread_tables(const Cloth& cloth);

/// Crossings of a window (it may run outside 0..count, where it wraps), row-major, a row a pick: height and slope
/// of the warp, of the weft, on the front.
std::vector<glm::vec4> thread_crossings(const Cloth& cloth, const CellRect& window);

/// Bound of the heights of threads with such crossings.
float highest_thread(const Cloth& cloth, const std::vector<glm::vec4>& crossings);

namespace thread_formulas {

/// Of a face; the back is seen mirrored, in the front's (u, v).
class ThreadScene {
 public:
  explicit ThreadScene(const Cloth& cloth, Face face = Face::kFront);

  vec4 thread_body(int system, int thread) const {
    return tables_.bodies[static_cast<size_t>(system)][static_cast<size_t>(thread)];
  }
  int thread_bin(int system, int bin) const {
    return tables_.first[static_cast<size_t>(system)][static_cast<size_t>(bin)];
  }
  vec4 crossing_at(int end, int pick) const {
    return crossings_[static_cast<size_t>(pick) * static_cast<size_t>(tables_.count.x) + static_cast<size_t>(end)];
  }
#define FORMULA
#include "shaders/threads.glsl"
#undef FORMULA
  ThreadGrid grid() const {
    return {tables_.count, tables_.bins, tables_.period, tables_.spacing, tables_.top, side_, tables_.even};
  }

 private:
  ThreadTables tables_;
  std::vector<glm::vec4> crossings_;
  float side_;
};

}  // namespace thread_formulas

using thread_formulas::ThreadScene;

}  // namespace weftlight::cloth
