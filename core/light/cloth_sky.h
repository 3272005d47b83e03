#pragma once
// Reflected light of a uniform sky: the scattered part is the far-field response summed over lights of the upper
// hemisphere; the mirrored part is sampled from the facets of each sample.

#include <array>
#include <vector>

#include "light/cloth_response.h"
#include "light/thread_samples.h"

namespace weftlight::light {

using cloth::Cloth;

/// Fills `sky` of both systems, `sky_from`, `near_sky` and `hidden`. samples, scale: those of the response and their
/// area scale; seen: visible area of both systems so scaled, by view.
void measure_sky(ClothResponse& response, const Cloth& cloth, const std::vector<ThreadSample>& samples,
                 const std::array<float, 2>& scale, const std::array<float, kResponseViews>& seen);

}  // namespace weftlight::light
