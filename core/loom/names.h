#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

namespace weftlight {
namespace draft {}
namespace loom {
using namespace draft;
}  // namespace loom
}  // namespace weftlight
