#pragma once
// The draft's colours: swatches, the colour in hand, and what the colour bars are painted with.

#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

MaybeEdit draw_palette(PanelContext& c);

}  // namespace weftlight::views
