#include "ui/fonts.h"

#include <imgui.h>

#include <cstring>
#include <string>
#include <vector>

#include "base/resources.h"
#include "base/whole_files.h"
#include "platform/catalogue.h"
#include "platform/installed_fonts.h"
#include "platform/missing_font.h"
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

/// Letters of the window's language that the fonts above lack; only they are loaded, since a font of Japanese is large.
struct Letters {
  platform::FontFace regular, bold;
  const ImWchar* ranges = nullptr;  // read until the atlas is built, after load_fonts
};

/// The texts of a compiled catalogue lie in it one after the other, each with a zero at its end.
void add_texts(ImFontGlyphRangesBuilder& letters, const std::string& language) {
  constexpr uint64_t kMaxBytes = uint64_t{16} << 20;
  const auto file = base::read_file(base::languages_dir() + "/" + language + "/LC_MESSAGES/weftlight.mo", kMaxBytes);
  for (size_t at = 0; file && at < file->size(); at += std::strlen(file->c_str() + at) + 1)
    letters.AddText(file->c_str() + at);
}

Letters letters_of_language() {
  const std::string language = platform::catalogue_language();
  if (!platform::needs_own_font(language)) return {};
  static std::vector<ImWchar> ranges;
  ImFontGlyphRangesBuilder letters;
  letters.AddRanges(ImGui::GetIO().Fonts->GetGlyphRangesJapanese());
  add_texts(letters, language);  // words of the craft have letters beyond the common ones
  ImVector<ImWchar> built;
  letters.BuildRanges(&built);
  ranges.assign(built.begin(), built.end());
  return {platform::font_face_of_language(language),
          platform::font_face_of_language(language, platform::FontWeight::kSemiBold), ranges.data()};
}

void merge_letters(const platform::FontFace& face, float size, const ImWchar* ranges) {
  if (face.file.empty()) return;
  ImFontConfig config;
  config.MergeMode = true;
  config.FontNo = face.index;
  // ImGui measures a font by its highest and lowest letters, which lie further apart in these.
  constexpr float kLarger = 1.2f;
  ImGui::GetIO().Fonts->AddFontFromFileTTF(face.file.c_str(), size * kLarger, &config, ranges);
}

}  // namespace

Fonts load_fonts(float pixels, float ratio) {
  using platform::font_file;
  pixels *= begin_fonts(ratio);
  const std::string text = font_file(kTextFonts), bold = font_file(kTextFonts, platform::FontWeight::kSemiBold);
  const std::string mono = font_file(kMonoFonts), icons = font_file(kIconFonts);
  Fonts fonts;
  fonts.icons = !icons.empty();
  const Letters letters = letters_of_language();
  fonts.text = add(text, kText * pixels);
  merge_letters(letters.regular, kText * pixels, letters.ranges);
  if (fonts.icons) merge_icons(icons, kIcons * pixels, pixels);
  fonts.small = add(text, kSmall * pixels);
  merge_letters(letters.regular, kSmall * pixels, letters.ranges);
  if (fonts.icons) merge_icons(icons, kSmall * pixels, pixels);
  fonts.bold = add(bold, kText * pixels);
  merge_letters(letters.bold, kText * pixels, letters.ranges);
  fonts.mono = add(mono, kMono * pixels);
  merge_letters(letters.regular, kMono * pixels, letters.ranges);
  fonts.mono_small = add(mono, kMonoSmall * pixels);
  merge_letters(letters.regular, kMonoSmall * pixels, letters.ranges);
  fonts.title = add(bold, kTitle * pixels);
  fonts.big = add(bold, kBig * pixels, kFigureRanges);
  end_fonts();
  return fonts;
}

}  // namespace weftlight::ui
