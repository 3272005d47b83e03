#pragma once
// Where the user's own files lie, by the XDG base directory specification.

#include <cstddef>
#include <string>

namespace weftlight::base {

/// $XDG_CONFIG_HOME/weftlight, or ~/.config/weftlight: settings.
std::string config_folder();
/// $XDG_STATE_HOME/weftlight, or ~/.local/state/weftlight: unsaved work, what --live-export wrote.
std::string state_folder();
/// $XDG_CACHE_HOME/weftlight, or ~/.cache/weftlight: what can be made again, as small pictures of drafts.
std::string cache_folder();

/// Leaves the newest `most` of a folder's files with that extension (".glb") and removes the older ones, as a cache
/// does. A folder that is not there is left so.
void keep_newest(const std::string& folder, const std::string& extension, size_t most);

}  // namespace weftlight::base
