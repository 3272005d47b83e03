#pragma once
// Internal to printing: the sheets, each as a function that draws it.

#include <cstdint>
#include <functional>
#include <vector>

#include "base/result.h"
#include "design/design.h"
#include "draft/drawdown.h"
#include "print/pen.h"
#include "print/print_options.h"

namespace weftlight::print {

using design::Design;
using draft::BitMatrix;

/// Draws one sheet.
using Sheet = std::function<void(const Pen&)>;

/// The sheets with the grids of the draft; if there are too many, none and `why`.
base::Result<std::vector<Sheet>> draft_sheets(const Design& design, const PrintOptions& options);
/// Lists of `listed`, a part of the design or all of it; plan, heddles and yarn of the planned cloth; swatch.
std::vector<Sheet> list_sheets(const Design& design, const Design& listed, const PrintOptions& options);

/// The front of the cloth, seen perpendicularly, each thread shaded as a cylinder, end 1 and pick 1 where the options
/// say: Cairo RGB24, `width` x `height` pixels.
std::vector<uint32_t> swatch_pixels(const Design& design, const BitMatrix& cells, const PrintOptions& options,
                                    int width, int height, double pixels_per_mm);

}  // namespace weftlight::print
