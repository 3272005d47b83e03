#pragma once
// The kinds of files that a dialog offers.

#include <string>
#include <vector>

#include "platform/desktop.h"

namespace weftlight::app {

/// Asks for a picture to weave.
inline constexpr const char* kPictureEnding = ".png";

/// For a file with this ending, such as ".wif", the kind in force first; none for a folder.
std::vector<platform::FileFilter> file_filters(platform::FileAsk what, const std::string& ending);

}  // namespace weftlight::app
