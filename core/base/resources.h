#pragma once
// Where the files that belong to the program are: presets, shaders, languages and the handbook.

#include <string>

namespace weftlight::base {

/// The folder of presets, of shaders, or of message catalogues (LANGUAGE/LC_MESSAGES/weftlight.mo). Searched in this
/// order: $WEFTLIGHT_PRESETS, $WEFTLIGHT_SHADERS or $WEFTLIGHT_LANGUAGES (used without a check); share/weftlight of an
/// installed program; the folder of the program or of the Python module and up to four above it, or share/weftlight in
/// one of them. A folder that is not found is that of an installed program, for the message that a file is missing.
std::string presets_dir();
std::string shaders_dir();
std::string languages_dir();
/// The first page of the handbook, found in the same way: $WEFTLIGHT_HANDBOOK is the folder of its pages, and an
/// installed program has them in share/doc/weftlight/handbook. "" where it was not built.
std::string handbook_page();

}  // namespace weftlight::base
