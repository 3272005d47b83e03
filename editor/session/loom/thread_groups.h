#pragma once
// The sections that a weaver counts by at the loom: those of the order that the threads were assembled by, else where
// the threading or treadling repeats itself.

#include <vector>

#include "design/design.h"
#include "loom/repeats.h"

namespace weftlight::session {

using design::Design;
using loom::ThreadGroup;

/// Of the ends on the loom (ends_on_loom), for which the draft repeats.
std::vector<ThreadGroup> groups_of_ends(const Design& design);
/// Of the picks of the draft.
std::vector<ThreadGroup> groups_of_picks(const Design& design);

/// "Section 3 of 12: end 5 of 16", by name if it has one; empty where everything is one section. `system`: of the
/// thread.
std::string group_text(const std::vector<ThreadGroup>& groups, draft::System system, int thread);

}  // namespace weftlight::session
