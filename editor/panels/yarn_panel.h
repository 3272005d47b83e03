#pragma once
// The design's yarns: which there are, and the body and the light of the one in hand.

#include "panels/names.h"
#include "panels/panel.h"
#include "panels/yarn_strip.h"

namespace weftlight::panels {

MaybeEdit draw_yarns(PanelContext& c, YarnStrip& strip);

}  // namespace weftlight::panels
