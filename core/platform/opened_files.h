#pragma once
// Files that the running program is to open, as the system says: dropped on a page, or in the link that opened it.

#include <string>
#include <vector>

namespace weftlight::platform {

/// Their paths, each once. Empty where a system starts the program for each file.
std::vector<std::string> take_opened_files();

}  // namespace weftlight::platform
