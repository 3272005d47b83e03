#pragma once
// A yarn's count in its panel: typed as it is sold, told in the units of the trade.

#include <string>

#include "views/common/panel.h"

namespace weftlight::views {

/// "Ne 40, Nm 67.7, 133 den", and below "follows the thickness"; of a count that is set, how much of it is fibre.
std::string count_in_words(const Yarn& yarn);

/// True while it changes the yarn.
bool draw_count(const PanelContext& c, Yarn& yarn);

}  // namespace weftlight::views
