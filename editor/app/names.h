#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "actions/names.h"
#include "commands/names.h"
#include "views/common/names.h"

namespace weftlight {
namespace app {
using namespace actions;
using namespace views;
using namespace commands;
}  // namespace app
}  // namespace weftlight
