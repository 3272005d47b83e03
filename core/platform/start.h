#pragma once
// What a program does before all else.

#include <string>
#include <vector>

namespace weftlight::platform {

/// Makes the standard streams carry bytes as they are, and gives the arguments in UTF-8, the program's name first. Call
/// it first in main.
std::vector<std::string> start(int argc, char** argv);

}  // namespace weftlight::platform
