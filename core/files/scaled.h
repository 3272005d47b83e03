#pragma once
// Pictures in another size.

#include "files/files.h"

namespace weftlight::files {

/// Each texel is the mean of its area.
Image scaled(Image image, int width, int height);

}  // namespace weftlight::files
