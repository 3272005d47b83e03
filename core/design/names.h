#pragma once
// The folders whose names these two use without saying whose they are.

namespace weftlight {
namespace draft {}
namespace design {
using namespace draft;
}
namespace weaves {
using namespace design;
}
}  // namespace weftlight
