#pragma once
// Imports the namespaces that this folder uses without qualification.

#include "render_data/names.h"
#include "texture_set/names.h"
#include "wif/names.h"

namespace weftlight {
namespace session {
using namespace wif;
using namespace render_data;
using namespace texture_set;
}  // namespace session
}  // namespace weftlight
