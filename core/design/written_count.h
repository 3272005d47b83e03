#pragma once
// The count of a yarn as its label says it, in the unit that is usual for its fibre.

#include <string>

#include "design/yarn.h"

namespace weftlight::design {

/// "Ne 16/2" for a cotton of two plies of Ne 16: see count_text() in count.h.
std::string written_count(const Yarn& yarn);

}  // namespace weftlight::design
