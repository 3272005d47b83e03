#pragma once
// The tour: five short notes, each beside its control, while the window stays usable.

#include <span>
#include <string>
#include <string_view>

#include "session/action_item.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::ActionItem;

inline constexpr int kTourSteps = 5;

/// Draws the step of Settings::tour. Call it last, because it looks up positions in the map. `items`: the actions whose
/// shortcuts the steps name.
void draw_tour(PanelContext& c, std::span<const ActionItem> items);

/// No step is shown any more, nor the tour at the next start.
void leave_tour(session::Settings& settings);

/// The text with each {id} replaced by the shortcut of that action, or by its place in the menus.
std::string with_keys(std::string_view words, std::span<const ActionItem> items);

}  // namespace weftlight::views
