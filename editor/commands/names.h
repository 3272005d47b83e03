#pragma once
// The folders whose names this one uses without saying whose they are; what those use comes with them.

#include "analysis/names.h"
#include "gl/names.h"
#include "texture_set/names.h"
#include "wif/names.h"

namespace weftlight {
namespace commands {
using namespace wif;
using namespace analysis;
using namespace gl;
using namespace texture_set;
}  // namespace commands
}  // namespace weftlight
