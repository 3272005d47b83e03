#pragma once
// What a killed program left beside the files that it was writing.

#include <string>

#include "session/names.h"

namespace weftlight::session {

/// Removes the temporary files of `path` (base::temporary_beside) whose owner is no more: those alone whose lock can be
/// had. Where there are no locks all stay, however old: a slow owner on another machine is no dead one.
void remove_stale_files(const std::string& path);

}  // namespace weftlight::session
