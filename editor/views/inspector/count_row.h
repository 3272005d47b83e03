#pragma once
// The yarn count: typed in any unit of the trade, shown in the others.

#include <string>

#include "views/common/panel.h"

namespace weftlight::views {

using design::Yarn;

/// "Ne 40, Nm 67.7, 133 den", and in a second line how the count is known; for a typed one, the fibre fraction.
std::string count_in_words(const Yarn& yarn);

/// True while it changes the yarn.
bool draw_count(const PanelContext& c, Yarn& yarn);

}  // namespace weftlight::views
