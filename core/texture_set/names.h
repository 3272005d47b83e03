#pragma once
// The folders whose names this one uses without saying whose they are: those of its row in the table of rooms.

namespace weftlight {
namespace base {}
namespace draft {}
namespace cloth {}
namespace light {}
namespace drape {}
namespace files {}
namespace texture_set {
using namespace base;
using namespace draft;
using namespace cloth;
using namespace light;
using namespace drape;
using namespace files;
}  // namespace texture_set
}  // namespace weftlight
