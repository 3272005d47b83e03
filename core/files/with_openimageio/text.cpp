#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include "files/files.h"
#include "platform/installed_fonts.h"

namespace weftlight::files {
namespace {

constexpr const char* kFamilies[] = {"Inter", "Noto Sans", "DejaVu Sans", "Helvetica"};

}  // namespace

void draw_text(Image& image, int x, int y, int size, const std::string& text, const std::vector<float>& colour) {
  if (image.texels.empty()) return;
  const std::string font = platform::font_file(kFamilies, platform::FontWeight::kMedium);
  if (font.empty()) return;
  const OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeDesc::FLOAT);
  OIIO::ImageBuf wrapped(spec, image.texels.data());
  OIIO::ImageBufAlgo::render_text(wrapped, x, y, text, size, font, colour);
}

}  // namespace weftlight::files
