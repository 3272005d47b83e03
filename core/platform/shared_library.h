#pragma once
// Libraries that are looked for while the program runs, because it can do without them.

namespace weftlight::platform {

/// Whether the system finds a library of this file name ("libEGL.so.1"). Once found it stays loaded.
bool has_library(const char* name);

}  // namespace weftlight::platform
