#pragma once
// What a typed file name means.

#include <string>

#include "session/names.h"

namespace weftlight::session {

/// "name" as "name.wif"; a path that ends in .wif, in any case, as it is.
std::string with_wif_ending(const std::string& path);

}  // namespace weftlight::session
