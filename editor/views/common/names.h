#pragma once
// Namespaces that the views use unqualified, with what those use themselves. Of gl only the name: just the cloth view
// includes its headers.

#include "session/files/names.h"
#include "ui/names.h"

namespace weftlight {
namespace gl {}
namespace views {
using namespace session;
using namespace gl;
using namespace ui;
}  // namespace views
}  // namespace weftlight
