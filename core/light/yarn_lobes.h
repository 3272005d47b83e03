#pragma once
// The lobes of a yarn as the formulas take them, and their evaluation in batches.

#include <span>

#include "cloth/cloth.h"
#include "draft/yarn.h"
#include "light/formulas.h"

namespace weftlight {

/// Lobes of a thread of this colour. Out-of-range values are clamped; never NaN.
formulas::YarnLobes yarn_lobes(const Lobes& lobes, Linear thread_colour);

/// out[k] = yarn_reflect(yarn, wi[k], wo[k]); all three of one length.
void reflect(const formulas::YarnLobes& yarn, std::span<const glm::vec3> wi, std::span<const glm::vec3> wo,
             std::span<glm::vec3> out);

}  // namespace weftlight
