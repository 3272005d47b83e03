#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "upload/names.h"
#include "wif/names.h"

namespace weftlight {
namespace session {
using namespace wif;
using namespace upload;
}  // namespace session
}  // namespace weftlight
