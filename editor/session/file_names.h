#pragma once
// What a typed file name means.

#include <string>

#include "session/names.h"

namespace weftlight::session {

/// "name" as "name.wif"; a path that ends in it (".wif"; drafts also in ".wifw"), in any case, as it is.
std::string with_file_ending(const std::string& path, const std::string& ending);

}  // namespace weftlight::session
