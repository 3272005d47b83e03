#pragma once
// Where the files that belong to the program lie: presets and shaders.

#include <string>

namespace weftlight::base {

/// Folders of presets and of shaders, the first of these that is one: $WEFTLIGHT_PRESETS or $WEFTLIGHT_SHADERS
/// (taken as it is), share/weftlight of an installed program, beside the program or up to three folders above it,
/// the source tree that it was built from.
std::string presets_dir();
std::string shaders_dir();

}  // namespace weftlight::base
