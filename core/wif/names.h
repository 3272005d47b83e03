#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "base/names.h"

namespace weftlight {
namespace draft {}
namespace design {}
namespace weaves {}
namespace wif {
using namespace base;
using namespace draft;
using namespace design;
using namespace weaves;
}  // namespace wif
}  // namespace weftlight
