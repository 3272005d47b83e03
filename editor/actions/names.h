#pragma once
// Imports the namespaces that this folder uses without qualification.

#include "session/files/names.h"

namespace weftlight {
namespace actions {
using namespace session;
}  // namespace actions
}  // namespace weftlight
