#pragma once
// A draft as a small picture: its drawdown in the colours of its threads, as one would hold the cloth at arm's length.

#include <cstdint>
#include <vector>

#include "draft/draft.h"
#include "session/names.h"

namespace weftlight::session {

/// RGBA of 8 bits, red lowest, encoded as sRGB; row 0 on top.
struct Thumbnail {
  int width = 0, height = 0;
  std::vector<uint32_t> pixels;
  bool operator==(const Thumbnail&) const = default;
};

/// End 1 at the right, pick 1 on top. A small draft is repeated over the picture, of a large one all is seen that fits
/// its shorter side. Empty where the draft has no crossing.
Thumbnail thumbnail_of(const Draft& draft, int width, int height);

}  // namespace weftlight::session
