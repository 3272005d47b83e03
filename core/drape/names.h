#pragma once
// The namespaces whose names this folder uses unqualified; the namespaces that those use come with them.

namespace weftlight {
namespace draft {}
namespace drape {
using namespace draft;
}  // namespace drape
}  // namespace weftlight
