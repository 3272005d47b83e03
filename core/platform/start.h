#pragma once
// What a program does before all else.

#include <string>
#include <vector>

namespace weftlight::platform {

/// Makes the standard streams carry bytes as they are, and gives the arguments in UTF-8, the program's name first. Call
/// it first in main.
std::vector<std::string> start(int argc, char** argv);

/// From now on freed memory is kept for the next that is taken, where it would go back to the system: for a command
/// that takes large blocks again and again and then ends.
void keep_freed_memory();

}  // namespace weftlight::platform
