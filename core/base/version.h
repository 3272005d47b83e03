#pragma once
// Which program this is.

#include <string>

namespace weftlight::base {

/// The version of the last release or of the one in the making, as exported files name it: "0.1.0".
std::string version();

}  // namespace weftlight::base
