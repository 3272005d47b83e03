// The fonts that come with the program, and those of Windows.

#include "platform/installed_fonts.h"

#include <array>
#include <string_view>

#include "platform/environment_variables.h"
#include "platform/file.h"
#include "platform/folders.h"
#include "platform/without/own_fonts.h"

namespace weftlight::platform {
namespace {

bool is_file(const std::string& path) { return file_facts(path).kind == FileKind::kRegular; }

std::string of_windows(const char* file) { return variable("SystemRoot") + "\\Fonts\\" + file; }

constexpr std::array<OwnFont, 5> kOwn{{{"Inter", FontWeight::kRegular, "Inter-Regular.otf"},
                                       {"Inter", FontWeight::kMedium, "Inter-Medium.otf"},
                                       {"Inter", FontWeight::kSemiBold, "Inter-SemiBold.otf"},
                                       {"JetBrains Mono", FontWeight::kRegular, "JetBrainsMono-Regular.ttf"},
                                       {"FontAwesome", FontWeight::kRegular, "fontawesome-webfont.ttf"}}};

struct SystemFont {
  std::string_view language;  // the first letters of its name
  const char* file;
};
/// Collections, whose first face is the upright one. The first of a language that is installed.
constexpr std::array<SystemFont, 6> kOfLanguage{{{"ja", "YuGothM.ttc"},
                                                 {"ja", "msgothic.ttc"},
                                                 {"zh", "msyh.ttc"},
                                                 {"ko", "malgun.ttf"},
                                                 {"", "segoeui.ttf"},
                                                 {"", "arial.ttf"}}};

}  // namespace

std::string font_file(std::span<const char* const> families, FontWeight weight) {
  for (const char* above : {"\\share", "\\..\\share"}) {
    std::string file = own_font_file(kOwn, program_folder() + above + "\\weftlight\\fonts\\", families, weight);
    if (!file.empty()) return file;
  }
  return {};
}

FontFace font_face_of_language(const std::string& language, FontWeight /*weight*/) {
  for (const SystemFont& font : kOfLanguage) {
    if (!std::string_view(language).starts_with(font.language)) continue;
    if (std::string path = of_windows(font.file); is_file(path)) return {path, 0};
  }
  return {};
}

}  // namespace weftlight::platform
