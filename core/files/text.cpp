// Text in pictures, through FreeType.

#include <ft2build.h>

#include FT_FREETYPE_H

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/utf8.h"
#include "base/whole_files.h"
#include "files/files.h"
#include "platform/installed_fonts.h"

namespace weftlight::files {
namespace {

constexpr const char* kFamilies[] = {"Inter", "Noto Sans", "DejaVu Sans", "Helvetica"};

struct EndLibrary {
  void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};
struct EndFace {
  void operator()(FT_Face face) const { FT_Done_Face(face); }
};

/// A font at a height in texels. Its members end in reverse order.
struct SizedFont {
  explicit SizedFont(int size) {
    constexpr uint64_t kMaxBytes = uint64_t{64} << 20;
    FT_Library opened = nullptr;
    FT_Face read = nullptr;
    const auto file = base::read_file(platform::font_file(kFamilies, platform::FontWeight::kMedium), kMaxBytes);
    if (!file || FT_Init_FreeType(&opened) != 0) return;
    bytes = *file, library.reset(opened);
    const auto* from = reinterpret_cast<const FT_Byte*>(bytes.data());
    if (FT_New_Memory_Face(opened, from, static_cast<FT_Long>(bytes.size()), 0, &read) != 0) return;
    face.reset(read);
    if (FT_Set_Pixel_Sizes(read, 0, static_cast<FT_UInt>(size)) != 0) face.reset();
  }
  std::string bytes;
  std::unique_ptr<std::remove_pointer_t<FT_Library>, EndLibrary> library;
  std::unique_ptr<std::remove_pointer_t<FT_Face>, EndFace> face;  // none if the font is not there, or is none
};

/// Mixes the ink into the texels that a letter covers; its bitmap has its upper left corner at (left, top).
void print(Image& image, const FT_Bitmap& letter, int left, int top, const std::vector<float>& ink) {
  const size_t channels = std::min(static_cast<size_t>(image.channels), ink.size());
  for (int j = std::max(0, -top); j < static_cast<int>(letter.rows) && top + j < image.height; ++j) {
    for (int i = std::max(0, -left); i < static_cast<int>(letter.width) && left + i < image.width; ++i) {
      const float cover = static_cast<float>(letter.buffer[j * letter.pitch + i]) / 255.0f;
      float* texel =
          &image.texels[static_cast<size_t>((top + j) * image.width + left + i) * static_cast<size_t>(image.channels)];
      for (size_t c = 0; c < channels; ++c) texel[c] = cover * ink[c] + (1.0f - cover) * texel[c];
    }
  }
}

}  // namespace

void draw_text(Image& image, int x, int y, int size, const std::string& text, const std::vector<float>& colour) {
  if (image.texels.empty()) return;
  const SizedFont font(size);
  if (!font.face) return;
  std::string_view rest = text;
  uint32_t letter = 0;
  while (const size_t length = base::utf8_sequence(rest, letter)) {
    rest.remove_prefix(length);
    if (FT_Load_Char(font.face.get(), letter, FT_LOAD_RENDER) != 0) continue;
    const auto& glyph = *font.face->glyph;
    if (glyph.bitmap.pixel_mode == FT_PIXEL_MODE_GRAY)
      print(image, glyph.bitmap, x + glyph.bitmap_left, y - glyph.bitmap_top, colour);
    x += static_cast<int>(glyph.advance.x >> 6);
  }
}

}  // namespace weftlight::files
