#pragma once
// Five things to know, each beside the control that it is about, while everything goes on working.

#include <span>
#include <string>
#include <string_view>

#include "session/action_item.h"
#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

inline constexpr int kTourSteps = 5;

/// While Settings::tour is a step; drawn last, since it points at what stands in the map.
/// `items`: the actions, of which the steps name keys.
void draw_tour(PanelContext& c, std::span<const ActionItem> items);

/// Words in which {id} stands for the key that runs an action, or for where it stands in the menus.
std::string with_keys(std::string_view words, std::span<const ActionItem> items);

}  // namespace weftlight::views
