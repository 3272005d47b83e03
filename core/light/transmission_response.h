#pragma once
// Far-field response of a cloth to light from behind it.

#include <array>
#include <vector>

#include "light/cloth_response.h"

namespace weftlight::light {

using cloth::Cloth;

/// Fills `transmitted` and `transmission_gradient` of both systems. seen: visible projected area by view, over the
/// cloth's.
void measure_transmission(ClothResponse& response, const Cloth& cloth, const ThreadSamples& threads,
                          const std::array<float, kResponseViews>& seen);

}  // namespace weftlight::light
