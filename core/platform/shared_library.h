#pragma once
// Libraries that are looked for while the program runs: because it can do without them, or seldom needs them.

#include <string>

namespace weftlight::platform {

/// Whether the system finds a library of this file name ("libEGL.so.1"). Once found it stays loaded.
bool has_library(const char* name);

/// A function of the library in a file, which is loaded if it is not yet, and stays. Null if there is none; `problem`
/// is the system's word for it.
void* function_of_library(const std::string& path, const char* function, std::string& problem);

}  // namespace weftlight::platform
