#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "cloth/names.h"
#include "drape/names.h"

namespace weftlight {
namespace files {
using namespace cloth;
using namespace drape;
}  // namespace files
}  // namespace weftlight
