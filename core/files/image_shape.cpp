#include "files/image_shape.h"

#include "base/text.h"

namespace weftlight::files {

using base::ErrorKind, base::arg, base::failure, base::fill, base::tr;

base::Result<void> check_shape(const Image& image, int max_channels, int64_t max_values, const std::string& path) {
  const int64_t values = int64_t{image.width} * image.height * image.channels;
  const bool fits = image.width >= 1 && image.width <= kMaxSide && image.height >= 1 && image.height <= kMaxSide &&
                    image.channels >= 1 && image.channels <= max_channels && values <= max_values;
  if (!fits)
    return failure(ErrorKind::kOutput,
                   fill(tr("an image of {width} x {height} x {channels} channels cannot be written"),
                        arg("width", image.width), arg("height", image.height), arg("channels", image.channels)),
                   path);
  if (static_cast<int64_t>(image.texels.size()) != values)
    return failure(ErrorKind::kOutput, tr("the texels of the image do not match its size"), path);
  return {};
}

}  // namespace weftlight::files
