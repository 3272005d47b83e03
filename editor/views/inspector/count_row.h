#pragma once
// The yarn count: typed in any unit of the trade, shown in the others.

#include <string>

#include "views/common/panel.h"

namespace weftlight::views {

using design::Design, design::Yarn;

/// "Ne 40, Nm 67.7, 133 den", and in a second line how the count is known; for a typed one, the fibre fraction.
std::string count_in_words(const Yarn& yarn);

/// True while it changes the yarn.
bool draw_count(const PanelContext& c, Yarn& yarn);
/// The count of the draft's threads of a yarn where they are not as thick as it: "Ends: 0.21 mm, 32.5 tex"; else empty.
std::string count_in_draft(const Design& design, int yarn);

}  // namespace weftlight::views
