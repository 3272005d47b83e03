#pragma once
// Temporary files that a killed program left beside the files it was writing.

#include <string>

namespace weftlight::session {

/// Removes the temporary files of `path` (platform::temporary_beside) whose owner has ended: those whose lock can be
/// taken. Without file locks all stay, however old: a slow owner on another machine may still be alive.
void remove_stale_files(const std::string& path);

}  // namespace weftlight::session
