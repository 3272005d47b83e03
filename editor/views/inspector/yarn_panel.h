#pragma once
// The design's yarns: which there are, and the body and the light of the one in hand.

#include "views/common/names.h"
#include "views/common/panel.h"
#include "views/inspector/yarn_strip.h"

namespace weftlight::views {

MaybeEdit draw_yarns(PanelContext& c, YarnStrip& strip);

}  // namespace weftlight::views
