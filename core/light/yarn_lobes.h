#pragma once
// Lobes of a yarn for the formulas, and their evaluation in batches.

#include <span>
#include <vector>

#include "cloth/cloth.h"
#include "design/yarn.h"
#include "light/formulas.h"
#include "platform/vectors.h"

namespace weftlight::light {

using cloth::Cloth, cloth::Linear, cloth::ThreadBody;
using design::Lobes;
using platform::Vectors, platform::widest_vectors;

/// Components of the mirrored light: reflectance of clear fibres at normal incidence, its fraction in the thread's
/// colour, and the body. Clear fibres lie in layers: n layers that each reflect r and pass the rest reflect n r / (1 +
/// (n - 1) r) (Stokes 1862, "On the intensity of the light reflected from or transmitted through a pile of plates",
/// without absorption). A metal has no clear part.
struct FibreReflectance {
  float clear = 0, fibre_layers = 1, dyed = 0, body = 0;  // fibre_layers: `clear` over that of one layer
};
FibreReflectance fibre_reflectance(const Lobes& lobes);

/// Parameters of a yarn as the shaders read them. Values are clamped to their ranges; never NaN.
interop::YarnData yarn_data(const Lobes& lobes);

/// Their means over the threads of a system; all 0 without threads.
interop::YarnData mean_yarn(const Cloth& cloth, const std::vector<ThreadBody>& threads);

/// Lobes of a thread of this colour. Values are clamped to their ranges; never NaN.
formulas::YarnLobes yarn_lobes(const Lobes& lobes, Linear thread_colour);

/// Mean of the channels, where one number stands for a colour. No single channel will do: a pure colour has 0 in the
/// others.
inline float channel_mean(const glm::vec3& c) { return (c.r + c.g + c.b) / 3; }

/// Weights of the channels, of sum 1, in the light of a yarn's body: for means of what only that light meets.
glm::vec3 body_weights(const formulas::YarnLobes& lobes);

/// out[k] = yarn_reflect(yarn, wi[k], wo[k]) up to rounding (relative 1e-4); all three have the same length. `vectors`
/// must be supported: at most widest_vectors().
void reflect(const formulas::YarnLobes& yarn, std::span<const glm::vec3> wi, std::span<const glm::vec3> wo,
             std::span<glm::vec3> out, Vectors vectors = widest_vectors());

}  // namespace weftlight::light
