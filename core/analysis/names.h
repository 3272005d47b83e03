#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

namespace weftlight {
namespace draft {}
namespace design {}
namespace weaves {}
namespace analysis {
using namespace draft;
using namespace design;
using namespace weaves;
}  // namespace analysis
}  // namespace weftlight
