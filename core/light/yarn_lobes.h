#pragma once
// The lobes of a yarn as the formulas take them, and their evaluation in batches.

#include <span>
#include <vector>

#include "cloth/cloth.h"
#include "draft/yarn.h"
#include "light/formulas.h"
#include "light/names.h"

namespace weftlight::light {

/// What the mirrored light is made of: reflectance of clear fibres at normal incidence, share of it that takes the
/// thread's colour, and what the body may send. Clear fibres lie one behind the other: a pile of so many layers, each
/// of which reflects r and passes the rest, sends back n r / (1 + (n - 1) r) (Stokes 1862, "On the intensity of the
/// light reflected from or transmitted through a pile of plates", without absorption). A metal has no clear light.
struct MirrorShares {
  float clear = 0, pile = 1, dyed = 0, body = 0;  // pile: `clear` over one layer's
};
MirrorShares mirror_shares(const Lobes& lobes);

/// The numbers of a yarn as the shaders take them. Out-of-range values are clamped; never NaN.
interop::YarnData yarn_data(const Lobes& lobes);

/// Their means over the threads of a system; all 0 where there are none.
interop::YarnData mean_yarn(const Cloth& cloth, const std::vector<ThreadBody>& threads);

/// Lobes of a thread of this colour. Out-of-range values are clamped; never NaN.
formulas::YarnLobes yarn_lobes(const Lobes& lobes, Linear thread_colour);

/// Mean of the channels: what stands for a colour where one number does. No channel counts for more than another, and
/// none alone: a pure colour has nothing in the others.
inline float channel_mean(const glm::vec3& c) { return (c.r + c.g + c.b) / 3; }

/// Shares of the channels, sum 1, in what a yarn's body sends: for means over the channels of what only it meets.
glm::vec3 body_shares(const formulas::YarnLobes& lobes);

/// The vectors that a batch runs on: the compiler's baseline, or AVX2 with FMA where the processor has them.
enum class Vectors { kBaseline, kAvx2 };
Vectors widest_vectors();

/// out[k] = yarn_reflect(yarn, wi[k], wo[k]) but for rounding (1e-4 of the value); all three of one length.
/// `vectors` must be there: at most widest_vectors().
void reflect(const formulas::YarnLobes& yarn, std::span<const glm::vec3> wi, std::span<const glm::vec3> wo,
             std::span<glm::vec3> out, Vectors vectors = widest_vectors());

}  // namespace weftlight::light
