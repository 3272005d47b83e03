#pragma once
// The design's yarns: which there are, and the body and the light of the one in hand.

#include "panels/panel.h"

namespace weftlight {

MaybeEdit draw_yarns(PanelContext& c);

}  // namespace weftlight
