#pragma once
// Where the files that belong to the program are: presets, shaders and languages.

#include <string>

namespace weftlight::base {

/// The folder of presets, of shaders, or of message catalogues (LANGUAGE/LC_MESSAGES/weftlight.mo). Searched in this
/// order: $WEFTLIGHT_PRESETS, $WEFTLIGHT_SHADERS or $WEFTLIGHT_LANGUAGES (used without a check); share/weftlight of an
/// installed program; the folder of the program or of the Python module and up to four above it, or share/weftlight in
/// one of them. A folder that is not found is that of an installed program, for the message that a file is missing.
std::string presets_dir();
std::string shaders_dir();
std::string languages_dir();

}  // namespace weftlight::base
