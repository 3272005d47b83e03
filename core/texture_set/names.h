#pragma once
// The namespaces whose names this folder uses unqualified; the namespaces that those use come with them.

#include "files/names.h"
#include "light/names.h"

namespace weftlight {
namespace texture_set {
using namespace files;
using namespace light;
}  // namespace texture_set
}  // namespace weftlight
