#pragma once
// A thumbnail of a draft: its drawdown in the colours of its threads.

#include <cstdint>
#include <vector>

#include "design/design.h"

namespace weftlight::session {

using design::Design;

/// RGBA8, red in the lowest byte, sRGB; row 0 on top.
struct Thumbnail {
  int width = 0, height = 0;
  std::vector<uint32_t> pixels;
  bool operator==(const Thumbnail&) const = default;
};

/// End 1 at the right, pick 1 on top. A small draft is repeated; a large one is shown as far as it fits its shorter
/// side. Empty if the draft has no crossing.
Thumbnail thumbnail_of(const Design& design, int width, int height);
/// The same of all its crossings, each once, in at most this size.
Thumbnail whole_draft(const Design& design, int width, int height);

}  // namespace weftlight::session
