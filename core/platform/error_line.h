#pragma once
// What a program says when something goes wrong.

#include <string>

namespace weftlight::platform {

/// Writes the line to the standard error. On Windows, where the program was opened by a double click and nobody would
/// read it, it stands in a box, and the call returns once the user has closed it.
void write_error_line(const std::string& line);

}  // namespace weftlight::platform
