#pragma once
// Opens a folder in the file manager.

#include <string>

#include "app/names.h"

namespace weftlight::app {

/// Starts xdg-open without waiting for it. Returns the error, or empty.
std::string open_folder(const std::string& folder);

}  // namespace weftlight::app
