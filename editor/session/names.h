#pragma once
// The folders whose names this one uses without saying whose they are: those of its row in the table of rooms.

namespace weftlight {
namespace draft {}
namespace wif {}
namespace session {
using namespace draft;
using namespace wif;
}  // namespace session
}  // namespace weftlight
