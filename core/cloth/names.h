#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "base/names.h"

namespace weftlight {
namespace draft {}
namespace cloth {
using namespace base;
using namespace draft;
}  // namespace cloth
}  // namespace weftlight
