#pragma once
// The colours along a thread of a yarn (design/dye.h), a row for each stretch.

#include "design/dye.h"
#include "views/common/panel.h"

namespace weftlight::views {

using design::Yarn;

/// A section, folded at first. own: stands for the thread's own colour; next: of a new stretch. True if the yarn was
/// changed.
bool draw_dye(const PanelContext& c, Yarn& yarn, draft::Rgb own, draft::Rgb next);

}  // namespace weftlight::views
