#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "session/names.h"

namespace weftlight {
namespace actions {
using namespace session;
}  // namespace actions
}  // namespace weftlight
