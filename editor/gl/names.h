#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "upload/names.h"

namespace weftlight {
namespace gl {
using namespace upload;
}  // namespace gl
}  // namespace weftlight
