#include "platform/without/own_fonts.h"

#include "platform/file.h"

namespace weftlight::platform {

std::string own_font_file(std::span<const OwnFont> fonts, const std::string& folder,
                          std::span<const char* const> families, FontWeight weight) {
  for (const std::string_view family : families)
    for (const OwnFont& font : fonts) {
      if (family != font.family || weight != font.weight) continue;
      if (std::string path = folder + font.file; file_facts(path).kind == FileKind::kRegular) return path;
    }
  return {};
}

}  // namespace weftlight::platform
