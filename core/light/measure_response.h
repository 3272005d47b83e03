#pragma once
// Measures the far-field response of a cloth (cloth_response.h).

#include "light/cloth_response.h"

namespace weftlight::light {

using cloth::Cloth, cloth::Maps;

inline constexpr int kResponseSamples = 2048;  // means are then within 4 percent on the charted cloths

/// Maps whose means are exact enough for a response: 16 texels across a thread, at most 768 a side.
Maps coarse_maps(const Cloth& cloth);

/// From `samples` surface samples of the threads and the means of the maps. Without threads or maps: all tables zero.
ClothResponse measure_response(const Cloth& cloth, const Maps& maps, int samples = kResponseSamples);

}  // namespace weftlight::light
