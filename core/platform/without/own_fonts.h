#pragma once
// Fonts that the program brings with it, where no system is asked for them.

#include <string>
#include <string_view>

#include "platform/installed_fonts.h"

namespace weftlight::platform {

struct OwnFont {
  std::string_view family;
  FontWeight weight;
  const char* file;
};
/// What font_file answers if `folder`, whose name ends with its separator, holds these fonts.
std::string own_font_file(std::span<const OwnFont> fonts, const std::string& folder,
                          std::span<const char* const> families, FontWeight weight);

}  // namespace weftlight::platform
