#pragma once
// Finds fonts that are installed on the system.

#include <span>
#include <string>

namespace weftlight::platform {

enum class FontWeight { kRegular, kMedium, kSemiBold };

/// The file (.ttf, .otf or .ttc) of the first of `families` that is installed, upright and in the closest weight. Empty
/// if none is installed.
std::string font_file(std::span<const char* const> families, FontWeight weight = FontWeight::kRegular);

/// A face in a file: collections (.ttc) hold several.
struct FontFace {
  std::string file;
  int index = 0;
};
/// The system's face for texts in a language, as "ja", in the closest weight. An empty file if no installed one has its
/// letters.
FontFace font_face_of_language(const std::string& language, FontWeight weight = FontWeight::kRegular);

}  // namespace weftlight::platform
