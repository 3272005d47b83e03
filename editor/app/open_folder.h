#pragma once
// A folder in the desktop's own file manager.

#include <string>

#include "app/names.h"

namespace weftlight::app {

/// Asks the desktop (xdg-open) and does not wait for it; what went wrong, or empty.
std::string open_folder(const std::string& folder);

}  // namespace weftlight::app
