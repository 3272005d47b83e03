#pragma once
// What a cloth sends from afar of a sky: its answers to lights, summed over lights from everywhere above.

#include "light/cloth_response.h"

namespace weftlight::light {

/// Fills `sky` of both systems and `sky_from` from their answers, slopes and colours.
void take_sky(ClothResponse& response, const Cloth& cloth);

}  // namespace weftlight::light
