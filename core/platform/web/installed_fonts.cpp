// The fonts that the page brings with it.

#include "platform/installed_fonts.h"

#include <array>

#include "platform/without/own_fonts.h"

namespace weftlight::platform {
namespace {

constexpr std::array<OwnFont, 5> kFonts{{{"Inter", FontWeight::kRegular, "Inter-Regular.otf"},
                                         {"Inter", FontWeight::kMedium, "Inter-SemiBold.otf"},
                                         {"Inter", FontWeight::kSemiBold, "Inter-SemiBold.otf"},
                                         {"JetBrains Mono", FontWeight::kRegular, "JetBrainsMono-Regular.ttf"},
                                         {"FontAwesome", FontWeight::kRegular, "FontAwesome.otf"}}};

}  // namespace

std::string font_file(std::span<const char* const> families, FontWeight weight) {
  return own_font_file(kFonts, "/weftlight/fonts/", families, weight);
}

FontFace font_face_of_language(const std::string& /*language*/, FontWeight /*weight*/) { return {}; }

}  // namespace weftlight::platform
