#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "reference/names.h"
#include "scene/names.h"

namespace weftlight {
namespace render_data {
using namespace scene;
using namespace reference;
}  // namespace render_data
}  // namespace weftlight
