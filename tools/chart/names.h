#pragma once
// The namespaces whose names this folder uses unqualified; the namespaces that those use come with them.

#include "gl/names.h"
#include "wif/names.h"

namespace weftlight {
namespace chart {
using namespace wif;
using namespace gl;
}  // namespace chart
}  // namespace weftlight
