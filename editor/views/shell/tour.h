#pragma once
// Five things to know, each beside the control that it is about, while everything goes on working.

#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

inline constexpr int kTourSteps = 5;

/// While Settings::tour is a step; drawn last, since it points at what stands in the map.
void draw_tour(PanelContext& c);

}  // namespace weftlight::views
