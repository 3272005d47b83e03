#pragma once
// What a cloth sends from afar of a sky: what scatters from its answers to lights, summed over lights from everywhere
// above; what mirrors from its places, each by directions that its own facets mirror into the view.

#include <array>
#include <vector>

#include "light/cloth_response.h"
#include "light/thread_samples.h"

namespace weftlight::light {

/// Fills `sky` of both systems, `sky_from` and `near_sky`. places: those of the answers; scale: of a system's areas, as
/// the answers have it; seen: of both systems so scaled, per view.
void measure_sky(ClothResponse& response, const Cloth& cloth, const std::vector<ThreadSample>& places,
                 const std::array<float, 2>& scale, const std::array<float, kResponseViews>& seen);

}  // namespace weftlight::light
