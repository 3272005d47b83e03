#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "files/names.h"
#include "reference/names.h"

namespace weftlight {
namespace render_data {
using namespace files;
using namespace reference;
}  // namespace render_data
}  // namespace weftlight
