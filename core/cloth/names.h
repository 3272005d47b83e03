#pragma once
// The folders whose names this one uses without saying whose they are: those of its row in the table of rooms.

namespace weftlight {
namespace base {}
namespace draft {}
namespace cloth {
using namespace base;
using namespace draft;
}  // namespace cloth
}  // namespace weftlight
