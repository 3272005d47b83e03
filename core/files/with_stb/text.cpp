// Text in pictures through stb_truetype, in the program's own font.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/utf8.h"
#include "base/whole_files.h"
#include "files/files.h"
#include "platform/installed_fonts.h"

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb_truetype.h>

namespace weftlight::files {
namespace {

constexpr const char* kFamilies[] = {"Inter"};

/// A font at a height in texels.
class SizedFont {
 public:
  /// None if the font is not there, or is none.
  static std::optional<SizedFont> at_height(int size) {
    constexpr uint64_t kMaxBytes = uint64_t{64} << 20;
    const auto file = base::read_file(platform::font_file(kFamilies, platform::FontWeight::kMedium), kMaxBytes);
    if (!file) return {};
    SizedFont font;
    font.bytes_ = *file;
    const auto* bytes = reinterpret_cast<const unsigned char*>(font.bytes_.data());
    if (stbtt_InitFont(&font.info_, bytes, stbtt_GetFontOffsetForIndex(bytes, 0)) == 0) return {};
    font.scale_ = stbtt_ScaleForMappingEmToPixels(&font.info_, static_cast<float>(size));
    return font;
  }
  SizedFont(const SizedFont&) = delete;
  SizedFont(SizedFont&&) = default;  // the bytes of a long string stay where they are
  SizedFont& operator=(const SizedFont&) = delete;

  /// Calls pixel(x, y, cover) for the texels of a letter at a pen on the base line, of which the fraction `cover` is
  /// ink.
  template <class Pixel>
  void draw(uint32_t letter, float pen, const Pixel& pixel) const {
    const float whole = std::floor(pen);
    int width = 0, height = 0, left = 0, top = 0;
    unsigned char* cover = stbtt_GetCodepointBitmapSubpixel(&info_, scale_, scale_, pen - whole, 0,
                                                            static_cast<int>(letter), &width, &height, &left, &top);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        pixel(static_cast<int>(whole) + left + x, top + y, static_cast<float>(cover[y * width + x]) / 255);
    stbtt_FreeBitmap(cover, nullptr);
  }
  /// How far the pen goes on from a letter to the next one.
  float advance(uint32_t letter, uint32_t next) const {
    int own = 0, bearing = 0;
    stbtt_GetCodepointHMetrics(&info_, static_cast<int>(letter), &own, &bearing);
    const int kern = stbtt_GetCodepointKernAdvance(&info_, static_cast<int>(letter), static_cast<int>(next));
    return scale_ * static_cast<float>(own + kern);
  }

 private:
  SizedFont() = default;
  std::string bytes_;
  stbtt_fontinfo info_{};
  float scale_ = 0;
};

std::vector<uint32_t> letters_of(std::string_view text) {
  std::vector<uint32_t> letters;
  uint32_t letter = 0;
  while (const size_t length = base::utf8_sequence(text, letter)) {
    letters.push_back(letter);
    text.remove_prefix(length);
  }
  return letters;
}

}  // namespace

void draw_text(Image& image, int x, int y, int size, const std::string& text, const std::vector<float>& colour) {
  if (image.texels.empty()) return;
  const std::optional<SizedFont> font = SizedFont::at_height(size);
  if (!font) return;
  const auto channels = static_cast<size_t>(image.channels);
  const auto ink = [&](int at_x, int at_y, float cover) {
    if (at_x < 0 || at_y + y < 0 || at_x >= image.width || at_y + y >= image.height) return;
    float* texel =
        &image.texels[(static_cast<size_t>(at_y + y) * static_cast<size_t>(image.width) + static_cast<size_t>(at_x)) *
                      channels];
    for (size_t c = 0; c < std::min(channels, colour.size()); ++c) texel[c] += (colour[c] - texel[c]) * cover;
  };
  const std::vector<uint32_t> letters = letters_of(text);
  float pen = static_cast<float>(x);
  for (size_t i = 0; i < letters.size(); ++i) {
    font->draw(letters[i], pen, ink);
    pen += font->advance(letters[i], i + 1 < letters.size() ? letters[i + 1] : 0);
  }
}

}  // namespace weftlight::files
