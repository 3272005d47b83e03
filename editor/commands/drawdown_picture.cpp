#include "commands/drawdown_picture.h"

#include <algorithm>

#include "base/text.h"
#include "files/files.h"

namespace weftlight::commands {

using base::arg, base::fill, base::tr;
using draft::Rgb;
using files::Image, files::PixelType, files::write_image;

namespace {

constexpr int64_t kMaxPixels = int64_t{1} << 27;  // 1.6 GB of float texels

/// Pixels per crossing, 1 to 16, so that the longer side is about 1,024.
int cell_size(const BitMatrix& cells) {
  constexpr int kWanted = 1024, kLargest = 16;
  return std::clamp(kWanted / std::max({cells.rows(), cells.cols(), 1}), 1, kLargest);
}

base::Failure too_many_for_image(const std::string& path, const BitMatrix& cells) {
  return base::failure(base::ErrorKind::kOutput,
                       fill(tr("{ends} by {picks} crossings are too many for a picture; write text instead"),
                            arg("ends", cells.cols()), arg("picks", cells.rows())),
                       path);
}

}  // namespace

const Rgb& ColoredCells::at(int x, int y) const {
  const int end = origin_.end1_left ? x : cells_.cols() - 1 - x,
            pick = origin_.pick1_bottom ? cells_.rows() - 1 - y : y;
  return color_on_top(draft_, dyed_, cells_.get(pick, end), end, pick);
}

base::Result<void> write_drawdown_image(const std::string& path, const ColoredCells& colors) {
  const BitMatrix& cells = colors.cells();
  if (int64_t{cells.rows()} * cells.cols() > kMaxPixels) return too_many_for_image(path, cells);
  const int size = cell_size(cells);
  Image image{cells.cols() * size, cells.rows() * size, 3, {}};
  image.texels.reserve(static_cast<size_t>(image.width) * static_cast<size_t>(image.height) * 3);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Rgb& c = colors.at(x / size, y / size);
      image.texels.insert(image.texels.end(), {c.r, c.g, c.b});
    }
  }
  return write_image(path, image, PixelType::kU8);
}

base::Result<void> write_drawdown_points(const std::string& path, const BitMatrix& cells) {
  if (int64_t{cells.rows()} * cells.cols() > kMaxPixels) return too_many_for_image(path, cells);
  Image image{cells.cols(), cells.rows(), 3, {}};
  image.texels.reserve(static_cast<size_t>(cells.cols()) * static_cast<size_t>(cells.rows()) * 3);
  for (int pick = 0; pick < cells.rows(); ++pick)
    for (int end = cells.cols() - 1; end >= 0; --end)
      image.texels.insert(image.texels.end(), 3, cells.get(pick, end) ? 0.0f : 1.0f);
  return write_image(path, image, PixelType::kU8);
}

}  // namespace weftlight::commands
