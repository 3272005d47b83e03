#pragma once
// The lobes of a yarn as the formulas take them, and their evaluation in batches.

#include <span>

#include "cloth/cloth.h"
#include "draft/yarn.h"
#include "light/formulas.h"
#include "light/names.h"

namespace weftlight::light {

/// The numbers of a yarn as the shaders take them. Out-of-range values are clamped; never NaN.
interop::YarnData yarn_data(const Lobes& lobes);

/// Lobes of a thread of this colour. Out-of-range values are clamped; never NaN.
formulas::YarnLobes yarn_lobes(const Lobes& lobes, Linear thread_colour);

/// The vectors that a batch runs on: the compiler's baseline, or AVX2 with FMA where the processor has them.
enum class Vectors { kBaseline, kAvx2 };
Vectors widest_vectors();

/// out[k] = yarn_reflect(yarn, wi[k], wo[k]) but for rounding (1e-4 of the value); all three of one length.
/// `vectors` must be there: at most widest_vectors().
void reflect(const formulas::YarnLobes& yarn, std::span<const glm::vec3> wi, std::span<const glm::vec3> wo,
             std::span<glm::vec3> out, Vectors vectors = widest_vectors());

}  // namespace weftlight::light
