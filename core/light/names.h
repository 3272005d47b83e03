#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "cloth/names.h"

namespace weftlight {
namespace light {
using namespace cloth;
}  // namespace light
}  // namespace weftlight
