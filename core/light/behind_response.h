#pragma once
// The part of a cloth's answer from afar that light from behind it has.

#include <array>
#include <vector>

#include "light/cloth_response.h"

namespace weftlight::light {

/// Fills `behind` of both systems. places: ThreadPlaces.behind; scale: of a system's places, to its share of the cover;
/// seen: projected area of what each view sees.
void take_behind(ClothResponse& response, const Cloth& cloth, const std::vector<ThreadPlace>& places,
                 const std::array<float, 2>& scale, const std::array<float, kResponseViews>& seen);

}  // namespace weftlight::light
