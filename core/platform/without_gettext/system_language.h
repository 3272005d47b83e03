#pragma once
// For systems without gettext, which finds it out itself.

#include <string>

namespace weftlight::platform {

/// The user's language as the system names it, "de_DE"; empty if it does not tell.
std::string system_language();

}  // namespace weftlight::platform
