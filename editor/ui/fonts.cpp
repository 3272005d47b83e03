#include "ui/fonts.h"

#include <imgui.h>

#include <string>

#include "platform/fonts.h"
#include "ui/imgui_compat.h"

namespace weftlight::ui {

using platform::font_file;

namespace {

constexpr const char* kTextFonts[] = {"Inter", "Inter Variable", "Noto Sans", "DejaVu Sans"};
constexpr const char* kMonoFonts[] = {"JetBrains Mono", "DejaVu Sans Mono"};
// The code points are those of Font Awesome 4; later versions have another family name.
constexpr const char* kIconFonts[] = {"FontAwesome"};

constexpr ImWchar kTextRanges[] = {0x20, 0x17F, 0x2010, 0x203A, 0x2190, 0x2193, 0x2212, 0x2212, 0x25CF, 0x25CF, 0};
constexpr ImWchar kIconRanges[] = {0xF000, 0xF2E0, 0};

// Sizes at 96 dpi.
constexpr ImWchar kFigureRanges[] = {'0', '9', 0};

constexpr float kTitle = 44, kBig = 230;
constexpr float kText = 15, kSmall = 13, kMono = 14, kMonoSmall = 12, kIcons = 16;

ImFont* add(const std::string& path, float size, const ImWchar* ranges = kTextRanges) {
  ImFontAtlas* atlas = ImGui::GetIO().Fonts;
  if (path.empty()) {
    ImFontConfig config;
    config.SizePixels = size;
    return atlas->AddFontDefault(&config);
  }
  return atlas->AddFontFromFileTTF(path.c_str(), size, nullptr, ranges);
}

void merge_icons(const std::string& path, float size, float offset_y) {
  ImFontConfig config;
  config.MergeMode = true;
  config.GlyphOffset.y = offset_y;
  ImGui::GetIO().Fonts->AddFontFromFileTTF(path.c_str(), size, &config, kIconRanges);
}

}  // namespace

Fonts load_fonts(float pixels, float ratio) {
  using platform::font_file;
  pixels *= begin_fonts(ratio);
  const std::string text = font_file(kTextFonts), bold = font_file(kTextFonts, platform::FontWeight::kSemiBold);
  const std::string mono = font_file(kMonoFonts), icons = font_file(kIconFonts);
  Fonts fonts;
  fonts.icons = !icons.empty();
  fonts.text = add(text, kText * pixels);
  if (fonts.icons) merge_icons(icons, kIcons * pixels, pixels);
  fonts.small = add(text, kSmall * pixels);
  if (fonts.icons) merge_icons(icons, kSmall * pixels, pixels);
  fonts.bold = add(bold, kText * pixels);
  fonts.mono = add(mono, kMono * pixels);
  fonts.mono_small = add(mono, kMonoSmall * pixels);
  fonts.title = add(bold, kTitle * pixels);
  fonts.big = add(bold, kBig * pixels, kFigureRanges);
  end_fonts();
  return fonts;
}

}  // namespace weftlight::ui
