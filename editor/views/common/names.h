#pragma once
// The folders whose names the views use without saying whose they are: those of their row in the table of rooms.

namespace weftlight {
namespace base {}
namespace draft {}
namespace wif {}
namespace cloth {}
namespace light {}
namespace drape {}
namespace upload {}
namespace gl {}
namespace session {}
namespace ui {}
namespace views {
using namespace base;
using namespace draft;
using namespace wif;
using namespace cloth;
using namespace light;
using namespace drape;
using namespace upload;
using namespace gl;
using namespace session;
using namespace ui;
}  // namespace views
}  // namespace weftlight
