#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "analysis/names.h"
#include "cloth/names.h"

namespace weftlight {
namespace print {
using namespace analysis;
using namespace cloth;
}  // namespace print
}  // namespace weftlight
