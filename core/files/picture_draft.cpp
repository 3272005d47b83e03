#include "files/picture_draft.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "draft/generators/families.h"
#include "files/files.h"

namespace weftlight::files {

using namespace wif;

namespace {

/// A pixel a crossing, laid out as `drawdown` draws: end 1 at the right, pick 1 at the top.
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

BitMatrix crossings_of(const Pixels& picture, const PictureDraft& asked) {
  std::set<std::tuple<float, float, float>> colors;
  for (const Rgb& c : picture.rgb)
    if (colors.size() < 9) colors.insert({c.r, c.g, c.b});
  PictureWeave how;
  how.colors = asked.colors > 0 ? asked.colors : static_cast<int>(std::min(colors.size(), size_t{8}));
  how.longest_float = asked.longest_float;
  if (colors.size() > 2 || asked.colors > 0) return picture_weave(picture, how);
  const Reduced reduced = reduced_colors(picture, 2);
  BitMatrix cells(picture.height, picture.width);
  for (size_t i = 0; i < reduced.index.size(); ++i)
    if (reduced.index[i] == 0)
      cells.set(static_cast<int>(i) / picture.width, static_cast<int>(i) % picture.width, true);
  return cells;
}

/// So many pixels wide, its shape kept: each the mean of those that it covers.
Image made_wide(Image image, int width) {
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

WifRead read_picture_draft(const std::string& path, const PictureDraft& how) {
  ReadImage read = read_image(path);
  const auto refuse = [](std::string what, std::string remedy) {
    return WifRead{{}, {{Severity::kError, 0, std::move(what), std::move(remedy)}}};
  };
  if (!read.image || read.image->channels < 1) return refuse(read.error, "choose a PNG or TIFF picture");
  if (how.ends > 0 && how.ends != read.image->width) read.image = made_wide(std::move(*read.image), how.ends);
  if (read.image->width > kMaxShafts || read.image->height > kMaxThreads)
    return refuse("the picture is " + std::to_string(read.image->width) + " by " + std::to_string(read.image->height),
                  "at most " + std::to_string(kMaxShafts) + " pixels across and " + std::to_string(kMaxThreads) +
                      " down become a draft; make it smaller");
  const std::optional<Design> design = jacquard_design(crossings_of(pixels_of(*read.image), how));
  if (!design) return refuse("the picture has no pixels", "choose another");
  WifFile file;
  file.design = *design;
  file.bytes = write_new_wif(*design);
  file.format = "picture";
  file.has_liftplan = file.rising_stated = true;
  return {std::move(file), {}};
}

}  // namespace weftlight::files
