#include "base/version.h"

namespace weftlight::base {

std::string version() { return WEFTLIGHT_VERSION; }

}  // namespace weftlight::base
