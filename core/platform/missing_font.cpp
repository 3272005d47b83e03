#include "platform/missing_font.h"

#include "platform/installed_fonts.h"

namespace weftlight::platform {

bool needs_own_font(const std::string& language) { return language == "ja" || language.starts_with("ja_"); }

std::string missing_font(const std::string& language) {
  const bool fine = !needs_own_font(language) || !font_face_of_language(language.substr(0, 2)).file.empty();
  return fine ? "" : "Noto Sans CJK (fonts-noto-cjk)";
}

}  // namespace weftlight::platform
