#pragma once
// Imports the namespaces that this folder uses without qualification.

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
