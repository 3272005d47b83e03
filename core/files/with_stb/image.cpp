// Images without OpenImageIO (WEFTLIGHT_OPENIMAGEIO is off), through stb: PNG and JPEG are read, PNG is written by this
// program itself, band by band. Other formats are refused in words.

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "base/file_names.h"
#include "base/text.h"
#include "base/whole_files.h"
#include "files/files.h"
#include "files/image_rows.h"
#include "files/image_shape.h"

#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_FAILURE_USERMSG
#include <stb_image.h>

namespace weftlight::files {

using base::ErrorKind, base::Result, base::arg, base::failed, base::failure, base::fill, base::tr,
    base::write_file_atomically;

namespace {

constexpr int kMaxChannels = 4;
constexpr int64_t kMaxValues = int64_t{1} << 28;  // 1 GiB of floats
constexpr int kPngLevel = 1;

base::Failure other_format(ErrorKind kind, const std::string& path) {
  return failure(kind, tr("this build supports PNG only; give a .png, or use the desktop program"), path);
}

/// Bytes of rows as PNG stores them: big-endian samples, each row behind its filter's number (2: "up").
class PngRows {
 public:
  PngRows(int width, int height, int channels, PixelType type) : row_(size_t(width) * size_t(channels)) {
    wide_ = type != PixelType::kU8;
    last_.resize(row_ * (wide_ ? 2 : 1));
    bytes_ = {137, 80, 78, 71, 13, 10, 26, 10};
    constexpr std::array<unsigned char, 4> kColors{0, 4, 2, 6};  // grey, grey and alpha, RGB, RGBA
    std::vector<unsigned char> head;
    put(head, static_cast<uint32_t>(width)), put(head, static_cast<uint32_t>(height));
    head.push_back(wide_ ? 16 : 8);
    head.push_back(kColors[static_cast<size_t>(channels - 1)]);
    head.insert(head.end(), {0, 0, 0});
    chunk("IHDR", head);
    deflateInit(&packer_, kPngLevel);
  }
  ~PngRows() { deflateEnd(&packer_); }
  PngRows(const PngRows&) = delete;
  PngRows& operator=(const PngRows&) = delete;

  void add(const std::vector<float>& texels) {
    std::vector<unsigned char> now(last_.size()), filtered(last_.size() + 1);
    for (size_t at = 0; at + row_ <= texels.size(); at += row_) {
      encode(&texels[at], now);
      filtered[0] = 2;
      for (size_t i = 0; i < now.size(); ++i) filtered[i + 1] = static_cast<unsigned char>(now[i] - last_[i]);
      last_.swap(now);
      pack(filtered, Z_NO_FLUSH);
    }
  }
  std::vector<unsigned char> finish() {
    pack({}, Z_FINISH);
    chunk("IDAT", packed_);
    chunk("IEND", {});
    return std::move(bytes_);
  }

 private:
  static void put(std::vector<unsigned char>& to, uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) to.push_back(static_cast<unsigned char>(value >> shift));
  }
  void chunk(std::string_view name, const std::vector<unsigned char>& data) {
    put(bytes_, static_cast<uint32_t>(data.size()));
    const size_t from = bytes_.size();
    bytes_.insert(bytes_.end(), name.begin(), name.end());
    bytes_.insert(bytes_.end(), data.begin(), data.end());
    put(bytes_, static_cast<uint32_t>(crc32(0, &bytes_[from], static_cast<uInt>(bytes_.size() - from))));
  }
  /// Rounds 0..1 to the whole range; NaN becomes 0.
  void encode(const float* texels, std::vector<unsigned char>& to) const {
    const float top = wide_ ? 65535.0f : 255.0f;
    for (size_t i = 0; i < row_; ++i) {
      const float v = texels[i];
      const auto value = static_cast<unsigned>(v > 0 ? std::min(v, 1.0f) * top + 0.5f : 0.0f);
      if (wide_) to[2 * i] = static_cast<unsigned char>(value >> 8), to[2 * i + 1] = static_cast<unsigned char>(value);
      else to[i] = static_cast<unsigned char>(value);
    }
  }
  void pack(std::vector<unsigned char> data, int flush) {
    packer_.next_in = data.data(), packer_.avail_in = static_cast<uInt>(data.size());
    std::array<unsigned char, 16384> out;
    do {
      packer_.next_out = out.data(), packer_.avail_out = static_cast<uInt>(out.size());
      deflate(&packer_, flush);
      packed_.insert(packed_.end(), out.begin(), out.end() - packer_.avail_out);
    } while (packer_.avail_out == 0);
  }

  size_t row_;
  bool wide_ = false;
  std::vector<unsigned char> last_, packed_, bytes_;
  z_stream packer_{};
};

struct FreeTexels {
  void operator()(void* texels) const { stbi_image_free(texels); }
};

Result<std::string> file_bytes(const std::string& path) {
  std::error_code ec;
  if (!std::filesystem::is_regular_file(path, ec)) return failure(ErrorKind::kInput, tr("no such file"), path);
  return base::read_file(path);
}

const stbi_uc* bytes_of(const std::string& file) { return reinterpret_cast<const stbi_uc*>(file.data()); }

base::Failure not_read(const std::string& path) {
  return failure(ErrorKind::kInput,
                 fill(tr("{problem}; this build reads PNG and JPEG"), arg("problem", stbi_failure_reason())), path);
}

}  // namespace

void load_pictures() {}  // they are part of the program

struct ImageRows::File {
  std::string path;
  int width = 0, height = 0, channels = 0, next = 0;
  std::unique_ptr<PngRows> rows;
};
ImageRows::ImageRows(std::unique_ptr<File> file) : file_(std::move(file)) {}
ImageRows::~ImageRows() = default;

Result<std::unique_ptr<ImageRows>> ImageRows::open(const std::string& path, int width, int height, int channels,
                                                   PixelType type, const std::vector<std::string>& /*names*/) {
  if (base::extension_of(path) != ".png" || channels < 1 || channels > 4) return other_format(ErrorKind::kOutput, path);
  auto file = std::make_unique<File>();
  file->path = path, file->width = width, file->height = height, file->channels = channels;
  file->rows = std::make_unique<PngRows>(width, height, channels, type);
  return std::unique_ptr<ImageRows>(new ImageRows(std::move(file)));
}
Result<std::unique_ptr<ImageRows>> ImageRows::open_mipmapped(const std::string& path, int /*width*/, int /*height*/,
                                                             const std::vector<std::string>& /*names*/) {
  return other_format(ErrorKind::kOutput, path);
}
Result<void> ImageRows::add(const Image& band, int /*level*/) {
  File& f = *file_;
  if (band.width != f.width || band.channels != f.channels || f.next + band.height > f.height)
    return failure(ErrorKind::kOutput, tr("a band does not fit the image"), f.path);
  f.next += band.height;
  f.rows->add(band.texels);
  return {};
}
Result<void> ImageRows::close() {
  File& f = *file_;
  if (f.next != f.height) return failure(ErrorKind::kOutput, tr("rows of the image are missing"), f.path);
  const std::vector<unsigned char> bytes = f.rows->finish();
  return write_file_atomically(f.path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Result<void> write_image(const std::string& path, const Image& image, PixelType type,
                         const std::vector<std::string>& /*channels*/) {
  if (base::extension_of(path) != ".png") return other_format(ErrorKind::kOutput, path);
  if (Result<void> shape = check_shape(image, kMaxChannels, kMaxValues, path); !shape) return shape;
  const std::vector<unsigned char> bytes = encode_png(image, type);
  return write_file_atomically(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Result<ImageSize> read_image_size(const std::string& path) {
  const Result<std::string> file = file_bytes(path);
  if (!file) return failed(file);
  ImageSize size;
  int channels = 0;
  if (!stbi_info_from_memory(bytes_of(*file), static_cast<int>(file->size()), &size.width, &size.height, &channels))
    return not_read(path);
  return size;
}

Result<Image> read_image(const std::string& path, int level) {
  if (level != 0) return failure(ErrorKind::kInput, fill(tr("has no mip level {level}"), arg("level", level)), path);
  const Result<std::string> file = file_bytes(path);
  if (!file) return failed(file);
  const int size = static_cast<int>(file->size());
  Image image;
  if (!stbi_info_from_memory(bytes_of(*file), size, &image.width, &image.height, &image.channels))
    return not_read(path);
  const int64_t values = int64_t{image.width} * image.height * image.channels;
  if (image.width > kMaxSide || image.height > kMaxSide || values > kMaxValues)
    return failure(ErrorKind::kInput,
                   fill(tr("an image of {width} x {height} x {channels} channels cannot be read; scale it down"),
                        arg("width", image.width), arg("height", image.height), arg("channels", image.channels)),
                   path);
  image.texels.resize(static_cast<size_t>(values));
  const bool wide = stbi_is_16_bit_from_memory(bytes_of(*file), size) != 0;
  const std::unique_ptr<void, FreeTexels> texels(
      wide ? static_cast<void*>(
                 stbi_load_16_from_memory(bytes_of(*file), size, &image.width, &image.height, nullptr, image.channels))
           : static_cast<void*>(
                 stbi_load_from_memory(bytes_of(*file), size, &image.width, &image.height, nullptr, image.channels)));
  if (!texels) return not_read(path);
  const auto fill_from = [&image](const auto* from, float top) {
    std::transform(from, from + image.texels.size(), image.texels.begin(), [top](auto v) { return v / top; });
  };
  if (wide) fill_from(static_cast<const uint16_t*>(texels.get()), 65535.0f);
  else fill_from(static_cast<const uint8_t*>(texels.get()), 255.0f);
  return image;
}

std::vector<unsigned char> encode_png(const Image& image, PixelType type) {
  if (!check_shape(image, kMaxChannels, kMaxValues, {})) return {};
  PngRows rows(image.width, image.height, image.channels, type);
  rows.add(image.texels);
  return rows.finish();
}

}  // namespace weftlight::files
