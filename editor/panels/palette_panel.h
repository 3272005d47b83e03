#pragma once
// The draft's colours: swatches, the colour in hand, and what the colour bars are painted with.

#include "panels/panel.h"

namespace weftlight {

MaybeEdit draw_palette(PanelContext& c);

}  // namespace weftlight
