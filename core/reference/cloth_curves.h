#pragma once
// The threads of a patch of cloth as curves, for close-ups in programs that draw hair: the geometry that the ray tracer
// of fibres uses, cut out along the edges of the patch.

#include <cstdint>
#include <glm/glm.hpp>

#include "base/result.h"
#include "cloth/curves.h"

namespace weftlight::reference {

enum class CurveDetail { kThreads, kPlies, kFibres };

struct CurveOptions {
  glm::vec2 low_mm{0}, high_mm{10, 10};
  CurveDetail detail = CurveDetail::kPlies;
  float raised = 0;  // finish: hair of a nap; the cloth is laid out without it
  uint32_t seed = 1;
  int64_t max_points = 4'000'000;  // more are refused before they are made
};

/// Threads are round, with the area of their flattened section; plies run inside that section, fibres as they are, with
/// hairs and loops. Errors: a patch without threads, more points than allowed (with the figure).
base::Result<cloth::Curves> cloth_curves(const cloth::Cloth& cloth, const CurveOptions& options);

}  // namespace weftlight::reference
