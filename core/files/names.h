#pragma once
// The folders whose names this one uses without saying whose they are: those of its row in the table of rooms.

namespace weftlight {
namespace base {}
namespace draft {}
namespace cloth {}
namespace drape {}
namespace files {
using namespace base;
using namespace draft;
using namespace cloth;
using namespace drape;
}  // namespace files
}  // namespace weftlight
