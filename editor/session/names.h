#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "texture_set/names.h"
#include "upload/names.h"
#include "wif/names.h"

namespace weftlight {
namespace session {
using namespace wif;
using namespace upload;
using namespace texture_set;
}  // namespace session
}  // namespace weftlight
