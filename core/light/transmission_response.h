#pragma once
// The part of a cloth's answer from afar that light from behind it has.

#include <array>
#include <vector>

#include "light/cloth_response.h"

namespace weftlight::light {

/// Fills `behind` and `transmission_lean` of both systems. seen: projected area of what each view sees, over the
/// cloth's.
void measure_transmission(ClothResponse& response, const Cloth& cloth, const ThreadSamples& threads,
                          const std::array<float, kResponseViews>& seen);

}  // namespace weftlight::light
