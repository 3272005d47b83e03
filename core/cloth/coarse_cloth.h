#pragma once
// A cloth of fewer, wider threads that looks alike from afar, for maps whose texels hold many threads.

#include "cloth/cloth.h"
#include "cloth/names.h"

namespace weftlight::cloth {

/// One end for so many of them, and one pick: each as wide as those whose place it takes, woven as one of them is.
/// Period and yarns stay. A cloth in layers stays as it is.
Cloth coarse_cloth(const Cloth& cloth, int ends_a_thread, int picks_a_thread);

}  // namespace weftlight::cloth
