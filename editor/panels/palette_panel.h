#pragma once
// The draft's colours: swatches, the colour in hand, and what the colour bars are painted with.

#include "panels/names.h"
#include "panels/panel.h"

namespace weftlight::panels {

MaybeEdit draw_palette(PanelContext& c);

}  // namespace weftlight::panels
