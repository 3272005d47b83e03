#pragma once
// Where the system keeps its fonts, asked of fontconfig.

#include <span>
#include <string>

namespace weftlight::base {

enum class FontWeight { kRegular, kMedium, kSemiBold };

/// File of the first of `families` that is installed, upright and in the weight nearest to the one asked for; a
/// .ttf, .otf or .ttc. Empty where none is.
std::string font_file(std::span<const char* const> families, FontWeight weight = FontWeight::kRegular);

}  // namespace weftlight::base
