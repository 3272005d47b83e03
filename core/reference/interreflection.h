#pragma once
// How much less a thread reflects once than its cloth shows (reflected_alone() of shaders/methods.glsl): a yarn's
// colour is that of its cloth, in which light has met several threads.

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "cloth/cloth.h"

namespace weftlight::reference {

/// Of light that each system reflects from everywhere, what comes from directions that other threads hide, over the
/// reflectance of its threads and relative to all visible cloth; 0 warp, 1 weft.
using HiddenParts = std::array<float, 2>;

/// unhidden_reflectance() of a thread.
glm::vec3 reflectance_of(const cloth::Cloth& cloth, const cloth::ThreadBody& body);

class Interreflection {
 public:
  /// The cloth must outlive this.
  Interreflection(const cloth::Cloth& cloth, const HiddenParts& hidden);
  /// The factor of each reflection at a position on the cloth (mm), 0 to 1 by channel. By the threads within a few of
  /// it; for a cloth of several layers by all.
  glm::vec3 alone(glm::vec2 position) const;

 private:
  const cloth::Cloth& cloth_;
  std::array<std::vector<glm::vec3>, 2> sent_;  // of ends and of picks: hidden part times mean reflectance around
};

}  // namespace weftlight::reference
