#include "commands/transparent.h"

#include <algorithm>

#include "design/srgb.h"

namespace weftlight::commands {

using design::srgb_decoded, design::srgb_encoded;
using files::PixelType, files::write_image;

namespace {

/// Colours that are not premultiplied, sRGB encoded; black where there is nothing.
Image straight(Image image) {
  for (size_t i = 0; i < image.texels.size(); i += 4) {
    const float alpha = image.texels[i + 3];
    for (size_t k = i; k < i + 3; ++k)
      image.texels[k] = alpha > 0 ? srgb_encoded(std::min(srgb_decoded(image.texels[k]) / alpha, 1.0f)) : 0.0f;
  }
  return image;
}

}  // namespace

Frame frame_over(const PictureSetup& setup, const PictureOptions& options, Backdrop backdrop) {
  Frame frame = setup.frame(options);
  frame.transparent = backdrop == Backdrop::kTransparent;
  frame.ground = !frame.transparent;
  return frame;
}

base::Result<void> write_drawn(const std::string& path, gl::Renderer& renderer, Backdrop backdrop) {
  // A scene-linear picture is drawn here, in memory of its own.
  const Image image = renderer.read_back(writes_linear(path));
  if (const auto& drawn = renderer.measure().cloth; !drawn) return drawn;
  return write_picture(path, image, backdrop);
}

base::Result<void> write_picture(const std::string& path, const Image& image, Backdrop backdrop) {
  if (backdrop == Backdrop::kShown || writes_linear(path)) return write_picture(path, image);
  return write_image(path, straight(image), PixelType::kU8);
}

}  // namespace weftlight::commands
