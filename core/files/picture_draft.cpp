#include "files/picture_draft.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "base/text.h"
#include "files/files.h"
#include "weaves/families.h"

namespace weftlight::files {

using base::arg, base::fill, base::message, base::tr;
using design::Design;
using draft::BitMatrix, draft::Rgb, draft::kMaxShafts, draft::kMaxThreads;
using weaves::PictureWeave, weaves::Pixels, weaves::Reduced, weaves::jacquard_design, weaves::picture_weave,
    weaves::reduced_colors;
using wif::Severity, wif::WifFile, wif::WifRead, wif::write_new_wif, wif::rejected;

namespace {

/// One crossing per pixel: end 1 at the right, pick 1 at the top.
Pixels pixels_of(const Image& image) {
  Pixels out{image.width, image.height, {}};
  const auto channels = static_cast<size_t>(image.channels);
  const size_t second = channels >= 3 ? 1 : 0, third = channels >= 3 ? 2 : 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = image.width - 1; x >= 0; --x) {
      const size_t at = (static_cast<size_t>(y) * static_cast<size_t>(image.width) + static_cast<size_t>(x)) * channels;
      out.rgb.push_back({image.texels[at], image.texels[at + second], image.texels[at + third]});
    }
  return out;
}

BitMatrix crossings_of(const Pixels& picture, const PictureDraft& options) {
  std::set<std::tuple<float, float, float>> colors;
  for (const Rgb& c : picture.rgb)
    if (colors.size() < 9) colors.insert({c.r, c.g, c.b});
  PictureWeave weave;
  weave.colors = options.colors > 0 ? options.colors : static_cast<int>(std::min(colors.size(), size_t{8}));
  weave.longest_float = options.longest_float;
  if (colors.size() > 2 || options.colors > 0) return picture_weave(picture, weave);
  const Reduced reduced = reduced_colors(picture, 2);
  BitMatrix cells(picture.height, picture.width);
  for (size_t i = 0; i < reduced.index.size(); ++i)
    if (reduced.index[i] == 0)
      cells.set(static_cast<int>(i) / picture.width, static_cast<int>(i) % picture.width, true);
  return cells;
}

/// Scales to a width and keeps the proportions; each pixel is the mean of its area.
Image scaled_to_width(Image image, int width) {
  const double scale = static_cast<double>(width) / image.width;
  const int height = std::clamp(static_cast<int>(std::lround(image.height * scale)), 1, kMaxThreads);
  Image out{width, height, image.channels, {}};
  out.texels.resize(static_cast<size_t>(width) * static_cast<size_t>(height) * static_cast<size_t>(image.channels));
  const OIIO::ImageBuf from(OIIO::ImageSpec(image.width, image.height, image.channels, OIIO::TypeDesc::FLOAT),
                            image.texels.data());
  OIIO::ImageBuf to(OIIO::ImageSpec(width, height, image.channels, OIIO::TypeDesc::FLOAT), out.texels.data());
  OIIO::ImageBufAlgo::resize(to, from, "box");
  return out;
}

}  // namespace

bool is_picture(const std::string& path) {
  std::string end = path.substr(path.find_last_of('.') + 1);
  for (char& c : end) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return end == "png" || end == "tif" || end == "tiff" || end == "bmp";
}

WifRead read_picture_draft(const std::string& path, const PictureDraft& options) {
  base::Result<Image> read = read_image(path);
  const auto refused = [](std::string what, std::string remedy) {
    return rejected({{Severity::kError, 0, std::move(what), std::move(remedy)}});
  };
  if (!read) return refused(message(read.error()), tr("choose a PNG or TIFF picture"));
  if (options.ends > 0 && options.ends != read->width) read = scaled_to_width(std::move(*read), options.ends);
  if (read->width > kMaxShafts || read->height > kMaxThreads)
    return refused(
        fill(tr("the picture is {width} by {height}"), arg("width", read->width), arg("height", read->height)),
        fill(tr("at most {across} pixels across and {down} down become a draft; make it smaller"),
             arg("across", int{kMaxShafts}), arg("down", int{kMaxThreads})));
  const std::optional<Design> design = jacquard_design(crossings_of(pixels_of(*read), options));
  if (!design) return refused(tr("the picture has no pixels"), tr("choose another"));
  WifFile file;
  file.design = *design;
  file.bytes = write_new_wif(*design);
  file.format = "picture";
  file.has_liftplan = file.rising_stated = true;
  return {std::move(file), {}};
}

}  // namespace weftlight::files
