// Images through OpenImageIO. Alpha stays unassociated in both directions (OpenImageIO would otherwise premultiply),
// and no colour-space chunk is written: the caller defines what a texel means.

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/text.h"
#include "base/whole_files.h"
#include "files/files.h"
#include "files/image_rows.h"
#include "files/image_shape.h"
#include "files/png_rows.h"

namespace weftlight::files {

using base::ErrorKind, base::Result, base::arg, base::failure, base::fill, base::tr, base::write_through;

namespace {

constexpr int kMaxChannels = 256;
constexpr int64_t kMaxValues = int64_t{1} << 29;  // 2 GiB of floats
constexpr float kMaxHalf = 65504.0f;
/// Rounds 0..1 to the whole range of T; NaN becomes 0.
template <class T>
std::vector<T> quantised(const std::vector<float>& values) {
  constexpr float top = static_cast<float>(static_cast<T>(~T{0}));
  std::vector<T> out(values.size());
  std::transform(
      values.begin(), values.end(), out.begin(),
      // Through int, for which there are vector conversions.
      [](float v) { return static_cast<T>(static_cast<int>(v > 0 ? std::min(v, 1.0f) * top + 0.5f : 0.0f)); });
  return out;
}

/// Clamps to the largest half float, 65504, so that brighter values do not become infinite.
std::vector<float> within_half(const std::vector<float>& values) {
  std::vector<float> out(values.size());
  std::transform(values.begin(), values.end(), out.begin(),
                 [](float v) { return std::isnan(v) ? 0.0f : std::clamp(v, -kMaxHalf, kMaxHalf); });
  return out;
}

OIIO::TypeDesc type_desc(PixelType type) {
  switch (type) {
    case PixelType::kU8:
      return OIIO::TypeDesc::UINT8;
    case PixelType::kU16:
      return OIIO::TypeDesc::UINT16;
    case PixelType::kHalf:
      return OIIO::TypeDesc::HALF;
    case PixelType::kFloat:
      break;
  }
  return OIIO::TypeDesc::FLOAT;
}

using Names = std::vector<std::string>;

/// The date in every .exr, so that the same image gives the same bytes.
constexpr const char* kNoDate = "2000:01:01 00:00:00";

OIIO::ImageSpec spec_for(const Image& image, PixelType type, const Names& names = {}) {
  OIIO::ImageSpec spec(image.width, image.height, image.channels, type_desc(type));
  spec.attribute("oiio:UnassociatedAlpha", 1);
  if (!names.empty()) {
    spec.channelnames = names;
    const auto alpha = std::find(names.begin(), names.end(), "A");
    spec.alpha_channel = alpha == names.end() ? -1 : static_cast<int>(alpha - names.begin());
  } else if (image.channels > 4) {  // EXR sorts channels by name; these names keep the order
    spec.channelnames.clear();
    for (int c = 0; c < image.channels; ++c) {
      std::string name = std::to_string(1000 + c);
      name[0] = 'c';
      spec.channelnames.push_back(name);
    }
    spec.alpha_channel = -1;
  }
  return spec;
}

bool write_texels(OIIO::ImageOutput& out, const Image& image, PixelType type) {
  switch (type) {
    case PixelType::kU8:
      return out.write_image(OIIO::TypeDesc::UINT8, quantised<uint8_t>(image.texels).data());
    case PixelType::kU16:
      return out.write_image(OIIO::TypeDesc::UINT16, quantised<uint16_t>(image.texels).data());
    case PixelType::kHalf:
      return out.write_image(OIIO::TypeDesc::FLOAT, within_half(image.texels).data());
    case PixelType::kFloat:
      break;
  }
  return out.write_image(OIIO::TypeDesc::FLOAT, image.texels.data());
}

Result<void> write_to(const std::string& path, const Image& image, PixelType type, const Names& names) {
  std::unique_ptr<OIIO::ImageOutput> out = OIIO::ImageOutput::create(path);
  if (!out)
    return failure(ErrorKind::kOutput,
                   fill(tr("{problem} (write .png, .exr, .tif or .jpg)"), arg("problem", OIIO::geterror())));
  const bool exr = std::string_view(out->format_name()) == "openexr";
  OIIO::ImageSpec spec = spec_for(image, type, exr ? names : Names{});
  // Piz suits noisy half data best (184 ms against zip's 407 ms for 2048^2 RGBA).
  if (exr) spec.attribute("compression", "piz"), spec.attribute("DateTime", kNoDate);
  if (!out->open(path, spec)) return failure(ErrorKind::kOutput, out->geterror());
  const bool written = write_texels(*out, image, type);
  const std::string problem = written ? "" : out->geterror();
  const bool closed = out->close();
  if (!written) return failure(ErrorKind::kOutput, problem);
  if (!closed) return failure(ErrorKind::kOutput, out->geterror());
  return {};
}

/// Bytes of the shortest file with such an image. Memory is taken for what the header says; a short file cannot mean
/// it.
uint64_t shortest_file(const std::string& format, const OIIO::ImageSpec& spec) {
  // A byte of deflate holds at most 1032, one of PackBits 64. Others have no such limit.
  const std::string packing = format == "png" ? "zip" : spec.get_string_attribute("compression");
  const uint64_t ratio = packing == "none" ? 1 : packing == "packbits" ? 64 : packing == "zip" ? 1032 : 0;
  if (ratio == 0 || (format != "png" && format != "tiff")) return 0;
  const int bits = spec.get_int_attribute("oiio:BitsPerSample", static_cast<int>(spec.format.size() * 8));
  // Of a palette a pixel is one sample, whatever the colours have.
  const uint64_t samples = static_cast<uint64_t>(spec.width) * static_cast<uint64_t>(spec.height);
  return samples * static_cast<uint64_t>(std::clamp(bits, 1, 64)) / 8 / ratio;
}

Result<Image> read_from(const std::string& path, int level) {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  std::unique_ptr<OIIO::ImageInput> in = OIIO::ImageInput::open(path, &config);
  if (!in) return failure(ErrorKind::kInput, OIIO::geterror());  // which names the file
  if (!in->seek_subimage(0, level))
    return failure(ErrorKind::kInput, fill(tr("has no mip level {level}"), arg("level", level)), path);
  const OIIO::ImageSpec& spec = in->spec();
  const int64_t values = int64_t{spec.width} * spec.height * spec.nchannels;
  const auto with_size = [&](const char* text) {
    return failure(ErrorKind::kInput,
                   fill(text, arg("width", spec.width), arg("height", spec.height), arg("channels", spec.nchannels)),
                   path);
  };
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || spec.width > kMaxSide || spec.height > kMaxSide ||
      spec.nchannels > kMaxChannels || values > kMaxValues || spec.depth > 1)
    return with_size(tr("an image of {width} x {height} x {channels} channels cannot be read; scale it down"));
  if (std::error_code ec; std::filesystem::file_size(path, ec) < shortest_file(in->format_name(), spec))
    return with_size(tr("the file is too short for {width} x {height} pixels; copy or export it again"));
  Image image{spec.width, spec.height, spec.nchannels, std::vector<float>(static_cast<size_t>(values))};
  if (!in->read_image(0, level, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.texels.data())) {
    return failure(ErrorKind::kInput, in->geterror(), path);
  }
  return image;
}

/// A file with mip levels has tiles of this side.
constexpr int kTileSide = 64;

/// A mip level; `next`: rows so far, which `halves` has, except of the finest.
struct Level {
  int width = 0, height = 0, next = 0;
  std::vector<uint16_t> halves;
};

/// The chain down to 1 x 1.
std::vector<Level> levels_of(int width, int height) {
  std::vector<Level> out;
  while (out.empty() || out.back().width > 1 || out.back().height > 1) {
    const size_t k = out.size();
    out.push_back({std::max(width >> k, 1), std::max(height >> k, 1), 0, {}});
  }
  return out;
}

}  // namespace

void load_pictures() {}  // they are part of the program

/// The rows of an .exr, or of another file of OpenImageIO's.
struct PictureRows : ImageRows {
  PictureRows() = default;
  using ImageRows::add;
  Result<void> add(const Image& band, int level) override;
  Result<void> close() override;

  std::string path;
  std::unique_ptr<OIIO::ImageOutput> out;
  int channels = 0;
  PixelType type = PixelType::kU8;
  std::vector<Level> levels;  // the image alone, or with all its mip levels
  // With mip levels only.
  bool has_tiles = false;
  Names names;
  std::vector<float> tiles;  // rows of the finest level that do not fill their tiles yet

  OIIO::ImageSpec spec_of(const Level& level) const {
    OIIO::ImageSpec spec = spec_for({level.width, level.height, channels, {}}, type, names);
    spec.tile_width = spec.tile_height = kTileSide;
    spec.tile_depth = 1;
    spec.attribute("compression", "piz");
    spec.attribute("DateTime", kNoDate);
    spec.attribute("textureformat", "Plain Texture");  // OpenImageIO's value for files with mip levels
    spec.attribute("openexr:roundingmode", 0);         // odd sizes are rounded down
    return spec;
  }
  bool add_scanlines(int first, const Image& band) const;
  bool add_to_level(size_t k, const Image& band);
  bool write_full_tiles();
  bool write_coarser_levels();
};

bool PictureRows::add_scanlines(int first, const Image& band) const {
  const int end = first + band.height;
  switch (type) {
    case PixelType::kU8:
      return out->write_scanlines(first, end, 0, OIIO::TypeDesc::UINT8, quantised<uint8_t>(band.texels).data());
    case PixelType::kU16:
      return out->write_scanlines(first, end, 0, OIIO::TypeDesc::UINT16, quantised<uint16_t>(band.texels).data());
    case PixelType::kHalf:
      return out->write_scanlines(first, end, 0, OIIO::TypeDesc::FLOAT, within_half(band.texels).data());
    case PixelType::kFloat:
      return out->write_scanlines(first, end, 0, OIIO::TypeDesc::FLOAT, band.texels.data());
  }
  return false;
}

bool PictureRows::add_to_level(size_t k, const Image& band) {
  Level& level = levels[k];
  const std::vector<float> values = within_half(band.texels);
  if (k == 0) {
    tiles.insert(tiles.end(), values.begin(), values.end());
    return write_full_tiles();
  }
  const size_t before = level.halves.size();
  level.halves.resize(before + values.size());
  return OIIO::convert_pixel_values(OIIO::TypeDesc::FLOAT, values.data(), OIIO::TypeDesc::HALF,
                                    level.halves.data() + before, static_cast<int>(values.size()));
}

bool PictureRows::write_full_tiles() {
  const Level& finest = levels.front();
  const size_t row = static_cast<size_t>(finest.width) * static_cast<size_t>(channels);
  const int held = static_cast<int>(tiles.size() / row), first = finest.next - held;
  const int whole = finest.next == finest.height ? held : held / kTileSide * kTileSide;
  if (whole == 0) return true;
  const bool written =
      out->write_tiles(0, finest.width, first, first + whole, 0, 1, OIIO::TypeDesc::FLOAT, tiles.data());
  tiles.erase(tiles.begin(), tiles.begin() + static_cast<ptrdiff_t>(row) * whole);
  return written;
}

bool PictureRows::write_coarser_levels() {
  for (size_t k = 1; k < levels.size(); ++k) {
    if (!out->open(path, spec_of(levels[k]), OIIO::ImageOutput::AppendMIPLevel) ||
        !out->write_image(OIIO::TypeDesc::HALF, levels[k].halves.data()))
      return false;
    levels[k].halves = {};
  }
  return true;
}

Result<void> PictureRows::add(const Image& band, int level) {
  const auto k = static_cast<size_t>(level);
  if (k >= levels.size()) return failure(ErrorKind::kOutput, tr("a band does not fit the image"), path);
  Level& to = levels[k];
  if (band.width != to.width || band.channels != channels || to.next + band.height > to.height)
    return failure(ErrorKind::kOutput, tr("a band does not fit the image"), path);
  const int first = std::exchange(to.next, to.next + band.height);
  if (has_tiles ? add_to_level(k, band) : add_scanlines(first, band)) return {};
  return failure(ErrorKind::kOutput, out->geterror(), path);
}

Result<void> PictureRows::close() {
  const bool complete = std::ranges::all_of(levels, [](const Level& l) { return l.next == l.height; });
  if (!complete) return failure(ErrorKind::kOutput, tr("rows of the image are missing"), path);
  if (write_coarser_levels() && out->close()) return {};
  return failure(ErrorKind::kOutput, out->geterror(), path);
}

Result<std::unique_ptr<ImageRows>> ImageRows::open(const std::string& path, int width, int height, int channels,
                                                   PixelType type, const Names& names) {
  if (is_png(path)) return open_png(path, width, height, channels, type);
  try {
    auto file = std::make_unique<PictureRows>();
    file->path = path, file->channels = channels, file->type = type;
    file->levels = {{width, height, 0, {}}};
    file->out = OIIO::ImageOutput::create(path);
    const bool exr = file->out && std::string_view(file->out->format_name()) == "openexr";
    OIIO::ImageSpec spec = spec_for({width, height, channels, {}}, type, exr ? names : Names{});
    if (exr) spec.attribute("compression", "piz"), spec.attribute("DateTime", kNoDate);
    if (file->out && file->out->open(path, spec)) return file;
    return failure(ErrorKind::kOutput, file->out ? file->out->geterror() : OIIO::geterror(), path);
  } catch (...) {
    return base::thrown(ErrorKind::kOutput, path);
  }
}

Result<std::unique_ptr<ImageRows>> ImageRows::open_mipmapped(const std::string& path, int width, int height,
                                                             const Names& names) {
  try {
    auto file = std::make_unique<PictureRows>();
    file->path = path, file->channels = static_cast<int>(names.size()), file->type = PixelType::kHalf;
    file->has_tiles = true, file->names = names;
    file->levels = levels_of(width, height);
    file->out = OIIO::ImageOutput::create(path);
    if (file->out && file->out->open(path, file->spec_of(file->levels.front()))) return file;
    return failure(ErrorKind::kOutput, file->out ? file->out->geterror() : OIIO::geterror(), path);
  } catch (...) {
    return base::thrown(ErrorKind::kOutput, path);
  }
}

Result<void> write_image(const std::string& path, const Image& image, PixelType type, const Names& channels) {
  if (is_png(path)) return write_png(path, image, type);
  if (Result<void> shape = check_shape(image, kMaxChannels, kMaxValues, path); !shape) return shape;
  if (!channels.empty() && channels.size() != static_cast<size_t>(image.channels))
    return failure(ErrorKind::kOutput, tr("some channels have no name"), path);
  return write_through(path, [&](const std::string& temporary) { return write_to(temporary, image, type, channels); });
}

Result<ImageSize> read_image_size(const std::string& path) {
  std::error_code ec;
  if (!std::filesystem::is_regular_file(path, ec)) return failure(ErrorKind::kInput, tr("no such file"), path);
  try {
    const std::unique_ptr<OIIO::ImageInput> in = OIIO::ImageInput::open(path);
    if (!in) return failure(ErrorKind::kInput, OIIO::geterror());  // which names the file
    return ImageSize{in->spec().width, in->spec().height};
  } catch (...) {
    return base::thrown(ErrorKind::kInput, path);
  }
}

Result<Image> read_image(const std::string& path, int level) {
  std::error_code ec;
  if (!std::filesystem::is_regular_file(path, ec)) return failure(ErrorKind::kInput, tr("no such file"), path);
  try {
    return read_from(path, level);
  } catch (...) {
    return base::thrown(ErrorKind::kInput, path);
  }
}

}  // namespace weftlight::files
