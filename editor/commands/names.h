#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "analysis/names.h"
#include "commands/chart/names.h"
#include "texture_set/names.h"

namespace weftlight {
namespace commands {
using namespace analysis;
using namespace chart;
using namespace texture_set;
}  // namespace commands
}  // namespace weftlight
