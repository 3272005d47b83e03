#pragma once
// The folders whose names this one uses without saying whose they are: those of its row in the table of rooms.

namespace weftlight {
namespace draft {}
namespace analysis {}
namespace print {
using namespace draft;
using namespace analysis;
}  // namespace print
}  // namespace weftlight
