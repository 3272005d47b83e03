#pragma once
// The folders whose names the views use without saying whose they are; what those use comes with them. Of gl the name
// alone: only the views of the cloth see its headers.

#include "session/names.h"
#include "ui/names.h"

namespace weftlight {
namespace gl {}
namespace views {
using namespace session;
using namespace gl;
using namespace ui;
}  // namespace views
}  // namespace weftlight
