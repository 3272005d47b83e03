// The fonts that the page brings with it.

#include "platform/fonts.h"

#include <array>
#include <string_view>

#include "platform/file.h"

namespace weftlight::platform {
namespace {

struct OwnFont {
  const char* family;
  FontWeight weight;
  const char* file;
};
constexpr std::array<OwnFont, 5> kFonts{{{"Inter", FontWeight::kRegular, "Inter-Regular.otf"},
                                         {"Inter", FontWeight::kMedium, "Inter-SemiBold.otf"},
                                         {"Inter", FontWeight::kSemiBold, "Inter-SemiBold.otf"},
                                         {"JetBrains Mono", FontWeight::kRegular, "JetBrainsMono-Regular.ttf"},
                                         {"FontAwesome", FontWeight::kRegular, "FontAwesome.otf"}}};

}  // namespace

std::string font_file(std::span<const char* const> families, FontWeight weight) {
  for (const std::string_view family : families)
    for (const OwnFont& font : kFonts) {
      if (family != font.family || weight != font.weight) continue;
      if (std::string path = std::string("/weftlight/fonts/") + font.file; file_facts(path).kind == FileKind::kRegular)
        return path;
    }
  return {};
}

FontFace font_face_of_language(const std::string& /*language*/, FontWeight /*weight*/) { return {}; }

}  // namespace weftlight::platform
