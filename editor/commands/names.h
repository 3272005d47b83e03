#pragma once
// The namespaces whose names this folder uses unqualified; the namespaces that those use come with them.

#include "analysis/names.h"
#include "chart/names.h"
#include "texture_set/names.h"

namespace weftlight {
namespace commands {
using namespace analysis;
using namespace chart;
using namespace texture_set;
}  // namespace commands
}  // namespace weftlight
