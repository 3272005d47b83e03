#pragma once
// The namespaces whose names this folder uses unqualified; the namespaces that those use come with them.

#include "cloth/names.h"
#include "drape/names.h"

namespace weftlight {
namespace files {
using namespace cloth;
using namespace drape;
}  // namespace files
}  // namespace weftlight
