#pragma once
// Where the files that belong to the program are: presets, shaders and languages.

#include <string>

namespace weftlight::base {

/// The folder of presets, of shaders, or of message catalogues (LANGUAGE/LC_MESSAGES/weftlight.mo). Searched in this
/// order: $WEFTLIGHT_PRESETS, $WEFTLIGHT_SHADERS or $WEFTLIGHT_LANGUAGES (used without a check); share/weftlight of an
/// installed program; the program's own folder and up to three above it, such as a build folder. A folder that is not
/// found is that of an installed program, for the message that a file is missing.
std::string presets_dir();
std::string shaders_dir();
std::string languages_dir();

}  // namespace weftlight::base
