#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "drape/names.h"
#include "light/names.h"

namespace weftlight {
namespace reference {
using namespace light;
using namespace drape;
}  // namespace reference
}  // namespace weftlight
