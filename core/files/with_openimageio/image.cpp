// Images through OpenImageIO. Alpha stays unassociated in both directions (OpenImageIO would otherwise premultiply),
// and no colour-space chunk is written: the caller defines what a texel means.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "base/file_names.h"
#include "base/text.h"
#include "base/whole_files.h"
#include "files/files.h"
#include "files/image_rows.h"
#include "files/image_shape.h"

namespace weftlight::files {

using base::ErrorKind, base::Result, base::arg, base::cause_of, base::failure, base::fill, base::tr,
    base::write_file_atomically, base::write_through;

namespace {

constexpr int kMaxChannels = 256;
constexpr int64_t kMaxValues = int64_t{1} << 29;  // 2 GiB of floats
constexpr float kMaxHalf = 65504.0f;
// zlib level of PNG. 2048^2 RGBA8: level 1 takes 0.5 s; level 6, OpenImageIO's default, 1.9 s for files 10% smaller.
constexpr int kPngLevel = 1;
// The filter "up". For maps of 2048^2, libpng's choice among five filters takes twice the time for files of the same
// size (normal map: 112 against 64 ms, 1560 against 1573 KB).
constexpr int kPngFilterUp = 32;

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
  spec.attribute("png:compressionLevel", kPngLevel);
  spec.attribute("png:filter", kPngFilterUp);
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

/// A PNG is written by this program, since OpenImageIO does not notice a full disk.
bool is_png(const std::string& path) { return base::extension_of(path) == ".png"; }

/// A file that records whether everything was written, which OpenImageIO does not notice.
class DiskFile : public OIIO::Filesystem::IOProxy {
 public:
  explicit DiskFile(const std::string& path)
      : IOProxy(path, IOProxy::Write), file_(std::fopen(path.c_str(), "wb")), whole_(file_ != nullptr) {}
  ~DiskFile() override { close(); }
  const char* proxytype() const override { return "disk"; }
  void close() override {
    if (!file_) return;
    whole_ = std::fclose(file_) == 0 && whole_;
    file_ = nullptr;
  }
  int64_t tell() override { return file_ ? std::ftell(file_) : 0; }
  bool seek(int64_t offset) override { return file_ && std::fseek(file_, offset, SEEK_SET) == 0; }
  size_t write(const void* data, size_t size) override {
    const size_t written = file_ ? std::fwrite(data, 1, size, file_) : 0;
    whole_ = whole_ && written == size;
    return size;  // an error would make the encoders throw or stop; it is reported at the end
  }
  bool whole() const { return whole_; }

 private:
  std::FILE* file_;
  bool whole_;
};

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

struct ImageRows::File {
  std::string path;
  std::unique_ptr<DiskFile> disk;  // PNG only
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

  /// libpng prints an error on the console if a file ends before its first texels are written, which are buffered at
  /// first. Noise rows flush that buffer.
  void flush_unfinished() const {
    constexpr size_t kOut = size_t{1} << 18;  // bytes of noise that are enough
    if (!out || !disk || levels.empty() || levels[0].next >= levels[0].height) return;
    const int next = levels[0].next, height = levels[0].height;
    std::vector<uint16_t> row(static_cast<size_t>(levels[0].width) * static_cast<size_t>(channels));
    const bool bytes_each = type == PixelType::kU8;
    const size_t bytes = row.size() * (bytes_each ? 1 : 2);
    uint32_t noise = 1;
    for (int y = next; y < height && static_cast<size_t>(y - next) * bytes < kOut; ++y) {
      for (uint16_t& v : row) v = static_cast<uint16_t>((noise = noise * 1664525u + 1013904223u) >> 16);
      out->write_scanlines(y, y + 1, 0, bytes_each ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16, row.data());
    }
  }
};

bool ImageRows::File::add_scanlines(int first, const Image& band) const {
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

bool ImageRows::File::add_to_level(size_t k, const Image& band) {
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

bool ImageRows::File::write_full_tiles() {
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

bool ImageRows::File::write_coarser_levels() {
  for (size_t k = 1; k < levels.size(); ++k) {
    if (!out->open(path, spec_of(levels[k]), OIIO::ImageOutput::AppendMIPLevel) ||
        !out->write_image(OIIO::TypeDesc::HALF, levels[k].halves.data()))
      return false;
    levels[k].halves = {};
  }
  return true;
}

ImageRows::ImageRows(std::unique_ptr<File> file) : file_(std::move(file)) {}

ImageRows::~ImageRows() {
  try {
    if (file_) file_->flush_unfinished();
  } catch (...) {  // no memory for it
  }
}

Result<std::unique_ptr<ImageRows>> ImageRows::open(const std::string& path, int width, int height, int channels,
                                                   PixelType type, const Names& names) {
  auto file = std::make_unique<File>();
  file->path = path, file->channels = channels, file->type = type;
  try {
    file->levels = {{width, height, 0, {}}};
    if (is_png(path)) file->disk = std::make_unique<DiskFile>(path);
    file->out = OIIO::ImageOutput::create(path, file->disk.get());
    const bool exr = file->out && std::string_view(file->out->format_name()) == "openexr";
    OIIO::ImageSpec spec = spec_for({width, height, channels, {}}, type, exr ? names : Names{});
    if (exr) spec.attribute("compression", "piz"), spec.attribute("DateTime", kNoDate);
    if (file->out && file->out->open(path, spec)) return std::unique_ptr<ImageRows>(new ImageRows(std::move(file)));
    return failure(ErrorKind::kOutput, file->out ? file->out->geterror() : OIIO::geterror(), path);
  } catch (...) {
    return base::thrown(ErrorKind::kOutput, path);
  }
}

Result<std::unique_ptr<ImageRows>> ImageRows::open_mipmapped(const std::string& path, int width, int height,
                                                             const Names& names) {
  auto file = std::make_unique<File>();
  file->path = path, file->channels = static_cast<int>(names.size()), file->type = PixelType::kHalf;
  file->has_tiles = true, file->names = names;
  try {
    file->levels = levels_of(width, height);
    file->out = OIIO::ImageOutput::create(path);
    if (file->out && file->out->open(path, file->spec_of(file->levels.front())))
      return std::unique_ptr<ImageRows>(new ImageRows(std::move(file)));
    return failure(ErrorKind::kOutput, file->out ? file->out->geterror() : OIIO::geterror(), path);
  } catch (...) {
    return base::thrown(ErrorKind::kOutput, path);
  }
}

Result<void> ImageRows::add(const Image& band, int level) {
  File& f = *file_;
  const auto k = static_cast<size_t>(level);
  if (k >= f.levels.size()) return failure(ErrorKind::kOutput, tr("a band does not fit the image"), f.path);
  Level& to = f.levels[k];
  if (band.width != to.width || band.channels != f.channels || to.next + band.height > to.height)
    return failure(ErrorKind::kOutput, tr("a band does not fit the image"), f.path);
  const int first = std::exchange(to.next, to.next + band.height);
  if (f.has_tiles ? f.add_to_level(k, band) : f.add_scanlines(first, band)) return {};
  return failure(ErrorKind::kOutput, f.out->geterror(), f.path);
}

Result<void> ImageRows::close() {
  File& f = *file_;
  const bool complete = std::ranges::all_of(f.levels, [](const Level& l) { return l.next == l.height; });
  if (!complete) return failure(ErrorKind::kOutput, tr("rows of the image are missing"), f.path);
  if (!f.write_coarser_levels()) return failure(ErrorKind::kOutput, f.out->geterror(), f.path);
  if (!f.out->close()) return failure(ErrorKind::kOutput, f.out->geterror(), f.path);
  if (!f.disk) return {};
  f.disk->close();
  if (f.disk->whole()) return {};
  return failure(ErrorKind::kOutput,
                 fill(tr("cannot be written: {cause}"), arg("cause", cause_of(errno ? errno : ENOSPC))), f.path);
}

Result<void> write_image(const std::string& path, const Image& image, PixelType type, const Names& channels) {
  if (Result<void> shape = check_shape(image, kMaxChannels, kMaxValues, path); !shape) return shape;
  if (!channels.empty() && channels.size() != static_cast<size_t>(image.channels))
    return failure(ErrorKind::kOutput, tr("some channels have no name"), path);
  if (is_png(path)) {
    const std::vector<unsigned char> bytes = encode_png(image, type);
    if (bytes.empty()) return failure(ErrorKind::kOutput, tr("cannot be encoded"), path);
    return write_file_atomically(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
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

std::vector<unsigned char> encode_png(const Image& image, PixelType type) {
  if (!check_shape(image, kMaxChannels, kMaxValues, {})) return {};
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  std::unique_ptr<OIIO::ImageOutput> out = OIIO::ImageOutput::create("memory.png", &memory);
  if (!out || !out->open("memory.png", spec_for(image, type))) return {};
  const bool whole = write_texels(*out, image, type == PixelType::kU8 ? type : PixelType::kU16);
  if (!out->close() || !whole) return {};
  return bytes;
}

}  // namespace weftlight::files
