#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "base/names.h"

namespace weftlight {
namespace draft {}
namespace design {}
namespace weaves {}
namespace cloth {
using namespace base;
using namespace draft;
using namespace design;
using namespace weaves;
}  // namespace cloth
}  // namespace weftlight
