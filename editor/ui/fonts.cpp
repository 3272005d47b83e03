#include "ui/fonts.h"

#include <imgui_freetype.h>

#include <array>
#include <filesystem>
#include <span>
#include <string>

namespace weftlight::ui {
namespace {

constexpr std::array kTextFonts = {
    "/usr/share/fonts/opentype/inter/Inter-Regular.otf", "/usr/share/fonts/truetype/inter/Inter-Regular.ttf",
    "/usr/share/fonts/inter/Inter-Regular.otf", "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"};
constexpr std::array kBoldFonts = {
    "/usr/share/fonts/opentype/inter/Inter-SemiBold.otf", "/usr/share/fonts/truetype/inter/Inter-SemiBold.ttf",
    "/usr/share/fonts/inter/Inter-SemiBold.otf", "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"};
constexpr std::array kMonoFonts = {"/usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-Regular.ttf",
                                   "/usr/share/fonts/jetbrains-mono/JetBrainsMono-Regular.ttf",
                                   "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf"};
constexpr std::array kIconFonts = {"/usr/share/fonts/truetype/font-awesome/fontawesome-webfont.ttf",
                                   "/usr/share/fonts-font-awesome/fonts/fontawesome-webfont.ttf",
                                   "/usr/share/fonts/opentype/font-awesome/FontAwesome.otf"};

constexpr ImWchar kTextRanges[] = {0x20, 0x17F, 0x2010, 0x203A, 0x2190, 0x2193, 0x2212, 0x2212, 0x25CF, 0x25CF, 0};
constexpr ImWchar kIconRanges[] = {0xF000, 0xF2E0, 0};

// Sizes at 96 dpi.
constexpr float kText = 15, kSmall = 13, kMono = 14, kMonoSmall = 12, kIcons = 16;

const char* first_there(std::span<const char* const> paths) {
  for (const char* path : paths)
    if (std::error_code error; std::filesystem::exists(path, error)) return path;
  return nullptr;
}

ImFont* add(const char* path, float size) {
  ImFontAtlas* atlas = ImGui::GetIO().Fonts;
  if (path == nullptr) {
    ImFontConfig own;
    own.SizePixels = size;
    return atlas->AddFontDefault(&own);
  }
  return atlas->AddFontFromFileTTF(path, size, nullptr, kTextRanges);
}

void merge_icons(const char* path, float size, float drop) {
  ImFontConfig config;
  config.MergeMode = true;
  config.GlyphOffset.y = drop;
  ImGui::GetIO().Fonts->AddFontFromFileTTF(path, size, &config, kIconRanges);
}

}  // namespace

Fonts load_fonts(float pixels, float ratio) {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  io.Fonts->FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  io.Fonts->FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  const char* text = first_there(kTextFonts);
  const char* icons = first_there(kIconFonts);
  Fonts fonts;
  fonts.icons = icons != nullptr;
  fonts.text = add(text, kText * pixels);
  if (fonts.icons) merge_icons(icons, kIcons * pixels, pixels);
  fonts.small = add(text, kSmall * pixels);
  if (fonts.icons) merge_icons(icons, kSmall * pixels, pixels);
  fonts.bold = add(first_there(kBoldFonts), kText * pixels);
  fonts.mono = add(first_there(kMonoFonts), kMono * pixels);
  fonts.mono_small = add(first_there(kMonoFonts), kMonoSmall * pixels);
  io.FontGlobalScale = 1 / ratio;
  io.Fonts->Build();
  return fonts;
}

}  // namespace weftlight::ui
