#pragma once
// The program's own folders for files of the user, in those that the system gives (platform/folders.h).

#include <cstddef>
#include <string>

namespace weftlight::base {

/// Settings. On Linux $XDG_CONFIG_HOME/weftlight, or ~/.config/weftlight.
std::string config_folder();
/// Unsaved work, what --live-export wrote. On Linux $XDG_STATE_HOME/weftlight, or ~/.local/state/weftlight.
std::string state_folder();
/// What can be made again, such as thumbnails of drafts. On Linux $XDG_CACHE_HOME/weftlight, or ~/.cache/weftlight.
std::string cache_folder();

/// Removes all but the newest `max_files` files with that extension (".glb") from a folder. A missing folder is no
/// error. `written`, just written, is the newest of them whatever the clock says: a file with a later time is from
/// before the clock was set back, and goes first.
void keep_newest(const std::string& folder, const std::string& extension, size_t max_files, const std::string& written);

}  // namespace weftlight::base
