#pragma once
// Finds fonts that are installed on the system.

#include <span>
#include <string>

namespace weftlight::platform {

enum class FontWeight { kRegular, kMedium, kSemiBold };

/// The file (.ttf, .otf or .ttc) of the first of `families` that is installed, upright and in the closest weight. Empty
/// if none is installed.
std::string font_file(std::span<const char* const> families, FontWeight weight = FontWeight::kRegular);

}  // namespace weftlight::platform
