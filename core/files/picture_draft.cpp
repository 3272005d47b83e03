#include "files/picture_draft.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "base/file_names.h"
#include "base/text.h"
#include "base/whole_files.h"
#include "design/repeat.h"
#include "draft/drawdown.h"
#include "files/files.h"
#include "files/scaled.h"
#include "weaves/families.h"
#include "wif/other_formats.h"

namespace weftlight::files {

using base::arg, base::fill, base::message, base::tr;
using draft::kMaxShafts, draft::kMaxThreads;
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

/// Whether the picture has at most two colours, and of how many weaves it is made otherwise.
struct Colors {
  bool crossings = false;
  int count = 2;
};

Colors colors_of(const Pixels& picture, const PictureDraft& options) {
  std::set<std::tuple<float, float, float>> colors;
  for (const Rgb& c : picture.rgb)
    if (colors.size() < 9) colors.insert({c.r, c.g, c.b});
  return {colors.size() <= 2 && options.colors <= 0 && options.weaves.empty(),
          options.colors > 0 ? options.colors : static_cast<int>(std::min(colors.size(), size_t{8}))};
}

/// The darker of two colours has the warp on top.
BitMatrix crossings_of(const Pixels& picture, const Reduced& reduced) {
  BitMatrix cells(picture.height, picture.width);
  for (size_t i = 0; i < reduced.index.size(); ++i)
    if (reduced.index[i] == 0)
      cells.set(static_cast<int>(i) / picture.width, static_cast<int>(i) % picture.width, true);
  return cells;
}

Image cropped(const Image& image, const PictureCrop& crop) {
  Image out{crop.width, crop.height, image.channels, {}};
  const auto channels = static_cast<size_t>(image.channels);
  for (int y = crop.top; y < crop.top + crop.height; ++y) {
    const size_t row = (static_cast<size_t>(y) * static_cast<size_t>(image.width) + static_cast<size_t>(crop.left));
    const auto first = image.texels.begin() + static_cast<std::ptrdiff_t>(row * channels);
    out.texels.insert(out.texels.end(), first, first + static_cast<std::ptrdiff_t>(out.width) * image.channels);
  }
  return out;
}

/// Ends and picks of a picture, or of its crop, with those options.
ImageSize threads_of(ImageSize picture, const PictureDraft& options) {
  if (options.crop.width > 0 && options.crop.height > 0) picture = {options.crop.width, options.crop.height};
  const ImageSize ends_first{options.ends > 0 ? options.ends : picture.width, 0};
  const double scale = static_cast<double>(ends_first.width) / picture.width;
  const double high = options.picks > 0 ? options.picks : std::round(picture.height * scale);
  return {ends_first.width, static_cast<int>(std::clamp(high, 1.0, 1e9))};
}

base::Failure unusable(std::string what) { return base::failure(base::ErrorKind::kInput, std::move(what)); }

std::string size_words(int width, int height) {
  return fill(tr("the picture is {width} by {height}"), arg("width", width), arg("height", height));
}

}  // namespace

bool is_picture(const std::string& path) {
  const std::string extension = base::extension_of(path);
  return extension == ".png" || extension == ".tif" || extension == ".tiff" || extension == ".bmp";
}

base::Result<Image> read_picture(const std::string& path) {
  const base::Result<ImageSize> size = read_image_size(path);  // before its pixels take memory
  if (!size) return base::Failure(size.error());
  if (size->width > kMaxPictureSide || size->height > kMaxPictureSide)
    return unusable(fill(tr("{size}; at most {most} pixels a side become a draft"),
                         arg("size", size_words(size->width, size->height)), arg("most", int{kMaxPictureSide})));
  return read_image(path);
}

base::Result<WovenPicture> woven_picture(const Image& picture, const PictureDraft& options,
                                         const base::TaskProgress& progress) {
  if (picture.width < 1 || picture.height < 1) return unusable(tr("the picture has no pixels"));
  const PictureCrop& crop = options.crop;
  const bool cuts = crop.width > 0 && crop.height > 0;
  if (cuts && (crop.left < 0 || crop.top < 0 || crop.left > picture.width - crop.width ||
               crop.top > picture.height - crop.height))
    return unusable(fill(tr("{size}; the part to weave reaches beyond it"),
                         arg("size", size_words(picture.width, picture.height))));
  const ImageSize threads = threads_of({picture.width, picture.height}, options);
  if (threads.width > kMaxShafts || threads.height > kMaxThreads)
    return unusable(fill(tr("{ends} ends and {picks} picks; at most {most_ends} and {most_picks} become a draft"),
                         arg("ends", threads.width), arg("picks", threads.height), arg("most_ends", int{kMaxShafts}),
                         arg("most_picks", int{kMaxThreads})));
  Image part = cuts ? cropped(picture, crop) : picture;
  if (part.width != threads.width || part.height != threads.height)
    part = scaled(std::move(part), threads.width, threads.height);
  const Pixels pixels = pixels_of(part);
  const Colors colors = colors_of(pixels, options);
  const Reduced reduced = reduced_colors(pixels, colors.crossings ? 2 : colors.count);
  PictureWeave weave{colors.count, options.longest_float, PictureWeave{}.shafts, options.weaves};
  std::optional<Design> design = jacquard_design(colors.crossings ? crossings_of(pixels, reduced)
                                                                  : picture_weave(pixels, reduced, weave, progress));
  if (!design) return unusable(tr("the picture has more crossings than a draft can have"));
  if (options.own_colors) design->draft.palette = {reduced.palette.front(), reduced.palette.back()};
  WovenPicture out{std::move(*design), reduced.palette, std::vector<float>(reduced.palette.size()), colors.crossings};
  for (const int color : reduced.index) out.portion[static_cast<size_t>(color)] += 1;
  for (float& portion : out.portion) portion /= static_cast<float>(reduced.index.size());
  return out;
}

base::Result<BitMatrix> read_weave(const std::string& words) {
  if (!wif::is_draft_name(words)) return weaves::read_weave_words(words);
  const base::Result<std::string> bytes = base::read_file(words, wif::kMaxDraftBytes);
  if (!bytes) return base::Failure(bytes.error());
  const WifRead read = wif::read_draft(*bytes);
  if (!read.file) return base::Failure(read.file.error());
  const BitMatrix cells = draft::drawdown(read.file->design.draft);
  const design::Repeat repeat = design::structure_repeat(cells);
  BitMatrix out(repeat.picks, repeat.ends);
  for (int pick = 0; pick < repeat.picks; ++pick)
    for (int end = 0; end < repeat.ends; ++end) out.set(pick, end, cells.get(pick, end));
  return out;
}

WifRead read_picture_draft(const std::string& path, const PictureDraft& options) {
  const auto refused = [](std::string what, std::string remedy) {
    return rejected({{Severity::kError, 0, std::move(what), std::move(remedy)}});
  };
  // Before its pixels take memory.
  const base::Result<ImageSize> size = read_image_size(path);
  if (!size) return refused(message(size.error()), tr("choose a PNG or TIFF picture"));
  const ImageSize threads = threads_of(*size, options);
  if (threads.width > kMaxShafts || threads.height > kMaxThreads)
    return refused(size_words(size->width, size->height),
                   fill(tr("at most {across} pixels across and {down} down become a draft; make it smaller"),
                        arg("across", int{kMaxShafts}), arg("down", int{kMaxThreads})));
  const base::Result<Image> read = read_image(path);
  if (!read) return refused(message(read.error()), tr("choose a PNG or TIFF picture"));
  base::Result<WovenPicture> woven = woven_picture(*read, options);
  if (!woven) return refused(message(woven.error()), tr("choose another, or other options"));
  WifFile file;
  file.bytes = write_new_wif(woven->design);
  file.design = std::move(woven->design);
  file.format = "picture";
  file.has_liftplan = file.rising_stated = true;
  return {std::move(file), {}};
}

}  // namespace weftlight::files
