#pragma once
// The folders for files of the user, by the XDG base directory specification.

#include <cstddef>
#include <string>

namespace weftlight::base {

/// $XDG_CONFIG_HOME/weftlight, or ~/.config/weftlight: settings.
std::string config_folder();
/// $XDG_STATE_HOME/weftlight, or ~/.local/state/weftlight: unsaved work, what --live-export wrote.
std::string state_folder();
/// $XDG_CACHE_HOME/weftlight, or ~/.cache/weftlight: what can be made again, such as thumbnails of drafts.
std::string cache_folder();

/// Removes all but the newest `max_files` files with that extension (".glb") from a folder. A missing folder is no
/// error.
void keep_newest(const std::string& folder, const std::string& extension, size_t max_files);

}  // namespace weftlight::base
