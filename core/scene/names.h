#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "files/names.h"
#include "light/names.h"

namespace weftlight {
namespace scene {
using namespace files;
using namespace light;
}  // namespace scene
}  // namespace weftlight
