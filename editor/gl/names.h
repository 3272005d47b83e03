#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "render_data/names.h"

namespace weftlight {
namespace gl {
using namespace render_data;
}  // namespace gl
}  // namespace weftlight
