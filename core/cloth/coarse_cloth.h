#pragma once
// A cloth of fewer, wider threads that looks the same in the far field, for maps whose texels hold many threads.

#include "cloth/cloth.h"

namespace weftlight::cloth {

/// Merges groups of ends and of picks into one thread each, as wide as the group and woven as one thread of it. Period
/// and yarns stay; a multi-layer cloth is returned unchanged.
Cloth coarse_cloth(const Cloth& cloth, int ends_a_thread, int picks_a_thread);

}  // namespace weftlight::cloth
