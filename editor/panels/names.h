#pragma once
// The folders whose names this one uses without saying whose they are: those of its row in the table of rooms.

namespace weftlight {
namespace draft {}
namespace wif {}
namespace cloth {}
namespace light {}
namespace drape {}
namespace upload {}
namespace gl {}
namespace panels {
using namespace draft;
using namespace wif;
using namespace cloth;
using namespace light;
using namespace drape;
using namespace upload;
using namespace gl;
}  // namespace panels
}  // namespace weftlight
