#include "files/scaled.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

namespace weftlight::files {

Image scaled(Image image, int width, int height) {
  Image out{width, height, image.channels, {}};
  out.texels.resize(static_cast<size_t>(width) * static_cast<size_t>(height) * static_cast<size_t>(image.channels));
  const OIIO::ImageBuf from(OIIO::ImageSpec(image.width, image.height, image.channels, OIIO::TypeDesc::FLOAT),
                            image.texels.data());
  OIIO::ImageBuf to(OIIO::ImageSpec(width, height, image.channels, OIIO::TypeDesc::FLOAT), out.texels.data());
  OIIO::ImageBufAlgo::resize(to, from, "box");
  return out;
}

}  // namespace weftlight::files
