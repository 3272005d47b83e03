#pragma once
// How much the fibres of a yarn absorb for their cloth to have the yarn's colour. Light meets tens of fibres before it
// leaves the cloth, fewer where yarns are thin or loose, so the same dye is deeper on a thick cloth than on a thin one.
// The colour that was chosen is that of the cloth (docs/decisions/colour-is-that-of-the-cloth.md), so the dye is found
// from it: by tracing the cloth's own fibres with dyes of known depth. What is wanted is what the threads reflect
// together, highlights included, so that tubes and fibres of a cloth are equally bright on the mean.

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "reference/fibre_scene.h"

namespace weftlight::reference {

using draft::System;

/// What a yarn's cloth reflects of white light from everywhere above, by what its fibres absorb.
class DyeCurve {
 public:
  static constexpr size_t kDepths = 14;
  /// `returned`: at each of dye_depth(0 .. kDepths - 1); `mirrored`: by the surfaces of the fibres alone. Noise that
  /// makes a deeper dye brighter is removed.
  DyeCurve(const std::array<float, kDepths>& returned, float mirrored);
  /// Absorption for a length of one radius, of fibres whose cloth has this reflectance. 0 where it is to be paler than
  /// clear fibres are, since the rest passes through the cloth.
  float absorption(float reflectance) const;

 private:
  float mirrored_;
  std::array<float, kDepths> body_{};  // of the light that enters fibres
};

/// What the threads of a cloth reflect of light from everywhere above, in the far field, by their colour.
class ThreadReflectance {
 public:
  explicit ThreadReflectance(const Cloth& cloth);
  glm::vec3 of(System system, int yarn, glm::vec3 colour) const;

 private:
  static constexpr size_t kSteps = 33;
  using ByColour = std::array<glm::vec3, kSteps>;  // by the root of a channel
  std::array<std::vector<ByColour>, 2> yarns_;     // of the warp, of the weft
};

/// Absorption of step i: 0, then a geometric row from 1e-4 to 10.
float dye_depth(size_t step);

/// One for each yarn of the cloth, for cloth of that yarn's fibres dyed alike, over low_mm to high_mm. A yarn that is
/// hardly seen there has that of the whole cloth. Repeatable.
std::vector<DyeCurve> measure_dyes(const FibreScene& fibres, glm::vec2 low_mm, glm::vec2 high_mm);

}  // namespace weftlight::reference
