#pragma once
// The two BRDFs of VRST 2003, figure 7.

#include <string_view>

#include "light/cloth_brdf.h"

namespace weftlight::light {

/// "cotton" (even shares, wide) and "satin" (long weft floats, narrow); colours as given.
inline ClothBrdf preset_cloth_brdf(std::string_view name, Linear warp, Linear weft) {
  if (name == "satin") return make_cloth_brdf(0.1f, 0.9f, 0.3f, 0.3f, warp, weft);
  return make_cloth_brdf(0.5f, 0.5f, 1.0f, 1.0f, warp, weft);
}

}  // namespace weftlight::light
