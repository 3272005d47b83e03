#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <filesystem>

#include "files/files.h"

namespace weftlight::files {
namespace {

constexpr const char* kFonts[] = {
    "/usr/share/fonts/opentype/inter/Inter-Medium.otf",
    "/usr/share/fonts/truetype/inter/Inter-Medium.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/System/Library/Fonts/Helvetica.ttc",
};

std::string system_font() {
  std::error_code ec;
  for (const char* font : kFonts) {
    if (std::filesystem::exists(font, ec)) return font;
  }
  return {};
}

}  // namespace

void draw_text(Image& image, int x, int y, int size, const std::string& text, const std::vector<float>& colour) {
  const std::string font = system_font();
  if (font.empty() || image.texels.empty()) return;
  const OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeDesc::FLOAT);
  OIIO::ImageBuf wrapped(spec, image.texels.data());
  OIIO::ImageBufAlgo::render_text(wrapped, x, y, text, size, font, colour);
}

}  // namespace weftlight::files
