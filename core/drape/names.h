#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

namespace weftlight {
namespace draft {}
namespace drape {
using namespace draft;
}  // namespace drape
}  // namespace weftlight
