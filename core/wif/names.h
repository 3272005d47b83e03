#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "base/names.h"

namespace weftlight {
namespace draft {}
namespace wif {
using namespace base;
using namespace draft;
}  // namespace wif
}  // namespace weftlight
