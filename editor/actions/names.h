#pragma once
// The folders whose names this one uses without saying whose they are: those of its row in the table of rooms.

namespace weftlight {
namespace base {}
namespace draft {}
namespace wif {}
namespace drape {}
namespace files {}
namespace session {}
namespace actions {
using namespace base;
using namespace draft;
using namespace wif;
using namespace drape;
using namespace files;
using namespace session;
}  // namespace actions
}  // namespace weftlight
