#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "gl/names.h"
#include "wif/names.h"

namespace weftlight {
namespace chart {
using namespace wif;
using namespace gl;
}  // namespace chart
}  // namespace weftlight
