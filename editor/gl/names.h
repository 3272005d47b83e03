#pragma once
// The folders whose names this one uses without saying whose they are: those of its row in the table of rooms.

namespace weftlight {
namespace base {}
namespace draft {}
namespace cloth {}
namespace light {}
namespace drape {}
namespace files {}
namespace reference {}
namespace upload {}
namespace gl {
using namespace base;
using namespace draft;
using namespace cloth;
using namespace light;
using namespace drape;
using namespace files;
using namespace reference;
using namespace upload;
}  // namespace gl
}  // namespace weftlight
