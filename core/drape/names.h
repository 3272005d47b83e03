#pragma once
// The namespaces whose names this folder uses unqualified; the namespaces that those use come with them.

namespace weftlight {
namespace draft {}
namespace design {}
namespace weaves {}
namespace drape {
using namespace draft;
using namespace design;
using namespace weaves;
}  // namespace drape
}  // namespace weftlight
