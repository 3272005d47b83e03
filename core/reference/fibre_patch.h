#pragma once
// The patch of cloth whose fibres are made, and what they cost.

#include <cstdint>
#include <glm/glm.hpp>

#include "cloth/cloth.h"

namespace weftlight::reference {

using cloth::Cloth;

struct FibreOptions {
  glm::vec2 low_mm{0}, high_mm{8, 8};    // the patch that is seen
  int64_t max_bytes = int64_t{2} << 30;  // more is refused before it is allocated
  float raised = 0;                      // finish: hair that a nap has more (the cloth is laid out without it)
  uint32_t seed = 1;
};

/// What the fibres of a patch are, and what they cost.
struct FibreFigures {
  glm::vec2 size_mm{0};  // of the cloth that is made, with its margins
  int threads = 0;
  int64_t fibres = 0, strays = 0;  // pieces of threads; hairs and loops
  int64_t curves = 0;              // straight pieces of fibres
  int64_t bytes = 0;               // estimated, while the scene is built: the most that it takes
};
FibreFigures fibre_figures(const Cloth& cloth, const FibreOptions& options);

}  // namespace weftlight::reference
