#pragma once
// What a killed program left beside the files that it was writing.

#include <string>

#include "session/names.h"

namespace weftlight::session {

/// Removes the temporary files "STEM.part-PROCESS-COUNT.EXT" beside `path` whose process is no more; those of other
/// files stay.
void remove_stale_files(const std::string& path);

}  // namespace weftlight::session
