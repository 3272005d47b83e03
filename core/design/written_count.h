#pragma once
// The count of a yarn as its label says it, in the unit of its trade: cotton Ne, wool Nm, linen lea, filament denier.

#include <string>

#include "design/yarn.h"

namespace weftlight::design {

/// "Ne 16/2" for a cotton of two plies of Ne 16: see count_text() in count.h. A count that is not set, but follows from
/// the thickness, is rounded.
std::string written_count(const Yarn& yarn);

}  // namespace weftlight::design
