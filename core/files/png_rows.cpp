#include "files/png_rows.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <new>
#include <string_view>
#include <utility>

#include "base/file_names.h"
#include "base/text.h"
#include "base/whole_files.h"
#include "files/image_shape.h"
#include "platform/file.h"
#include "platform/vectors.h"

namespace weftlight::files {

using base::ErrorKind, base::Result, base::arg, base::cause_of, base::failure, base::fill, base::tr,
    base::write_file_atomically;

namespace {

constexpr int kMaxChannels = 4;
constexpr int64_t kMaxValues = int64_t{1} << 29;  // 2 GiB of floats
// zlib level. 2048^2 RGBA8: level 1 takes 0.5 s; level 6, zlib's default, 1.9 s for files 10% smaller.
constexpr int kLevel = 1;
// The filter "up". For maps of 2048^2, the best of five filters for each row takes twice the time for files of the same
// size (normal map: 112 against 64 ms, 1560 against 1573 KB).
constexpr unsigned char kFilterUp = 2;
constexpr size_t kChunk = 8192;  // bytes of packed texels

/// Rounds 0..1 to 0..top; NaN becomes 0. Without a branch, and through int, so that loops over it become vectors.
inline int stored(float v, float top) {
  const float positive = v > 0.0f ? v : 0.0f, inside = positive < 1.0f ? positive : 1.0f;
  return static_cast<int>(inside * top + 0.5f);
}

// Bytes may be any object: without __restrict, loops that write them do not become vectors.

inline void to_bytes(unsigned char* __restrict to, const float* __restrict from, size_t count) {
  for (size_t i = 0; i < count; ++i) to[i] = static_cast<unsigned char>(stored(from[i], 255.0f));
}

/// Big-endian.
inline void to_pairs(unsigned char* __restrict to, const float* __restrict from, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    const int value = stored(from[i], 65535.0f);
    to[2 * i] = static_cast<unsigned char>(value >> 8), to[2 * i + 1] = static_cast<unsigned char>(value);
  }
}

inline void subtract(unsigned char* __restrict to, const unsigned char* __restrict from,
                     const unsigned char* __restrict less, size_t count) {
  for (size_t i = 0; i < count; ++i) to[i] = static_cast<unsigned char>(from[i] - less[i]);
}

void put(std::vector<unsigned char>& to, uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) to.push_back(static_cast<unsigned char>(value >> shift));
}

/// A file that is written as its rows come.
class PngFile : public ImageRows {
 public:
  PngFile(std::string path, int width, int height, int channels, PixelType type)
      : path_(std::move(path)),
        width_(width),
        height_(height),
        channels_(channels),
        rows_(width, height, channels, type),
        file_(platform::open_stream(path_, "wb")) {}
  ~PngFile() override {
    if (file_ != nullptr) std::fclose(file_);
  }
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;
  bool is_open() const { return file_ != nullptr; }

  using ImageRows::add;
  Result<void> add(const Image& band, int level) override {
    if (level != 0 || band.width != width_ || band.channels != channels_ || next_ + band.height > height_)
      return failure(ErrorKind::kOutput, tr("a band does not fit the image"), path_);
    next_ += band.height;
    rows_.add(band.texels);
    return write();
  }
  Result<void> close() override {
    if (next_ != height_) return failure(ErrorKind::kOutput, tr("rows of the image are missing"), path_);
    rows_.finish();
    Result<void> written = write();
    errno = 0;
    if (std::fclose(std::exchange(file_, nullptr)) != 0 && written) return not_written();
    return written;
  }

 private:
  Result<void> write() {
    const std::vector<unsigned char> bytes = rows_.take();
    errno = 0;
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_) == bytes.size()) return {};
    return not_written();
  }
  Result<void> not_written() const {
    return failure(ErrorKind::kOutput,
                   fill(tr("cannot be written: {cause}"), arg("cause", cause_of(errno != 0 ? errno : ENOSPC))), path_);
  }

  std::string path_;
  int width_, height_, channels_, next_ = 0;
  PngRows rows_;
  std::FILE* file_;
};

}  // namespace

bool is_png(const std::string& path) { return base::extension_of(path) == ".png"; }

PngRows::PngRows(int width, int height, int channels, PixelType type)
    : values_(static_cast<size_t>(width) * static_cast<size_t>(channels)), wide_(type != PixelType::kU8) {
  last_.resize(values_ * (wide_ ? 2 : 1)), now_.resize(last_.size()), filtered_.resize(last_.size() + 1);
  filtered_[0] = kFilterUp;
  bytes_ = {137, 80, 78, 71, 13, 10, 26, 10};
  constexpr std::array<unsigned char, kMaxChannels> kColors{0, 4, 2, 6};  // grey, grey and alpha, RGB, RGBA
  std::vector<unsigned char> head;
  put(head, static_cast<uint32_t>(width)), put(head, static_cast<uint32_t>(height));
  head.push_back(wide_ ? 16 : 8);
  head.push_back(kColors[static_cast<size_t>(channels - 1)]);
  head.insert(head.end(), {0, 0, 0});
  chunk("IHDR", head.data(), head.size());
  packed_.reserve(kChunk);
  if (deflateInit(&packer_, kLevel) != Z_OK) throw std::bad_alloc();
}

PngRows::~PngRows() { deflateEnd(&packer_); }

void PngRows::add(const std::vector<float>& texels) {
  for (size_t at = 0; at + values_ <= texels.size(); at += values_) {
    platform::with_widest_vectors([&] {
      if (wide_) to_pairs(now_.data(), &texels[at], values_);
      else to_bytes(now_.data(), &texels[at], values_);
      subtract(filtered_.data() + 1, now_.data(), last_.data(), now_.size());
    });
    last_.swap(now_);
    pack(filtered_, Z_NO_FLUSH);
  }
}

void PngRows::finish() {
  pack({}, Z_FINISH);
  if (!packed_.empty()) chunk("IDAT", packed_.data(), packed_.size());
  chunk("IEND", nullptr, 0);
}

std::vector<unsigned char> PngRows::take() { return std::exchange(bytes_, {}); }

void PngRows::chunk(std::string_view name, const unsigned char* data, size_t size) {
  put(bytes_, static_cast<uint32_t>(size));
  const size_t from = bytes_.size();
  bytes_.insert(bytes_.end(), name.begin(), name.end());
  bytes_.insert(bytes_.end(), data, data + size);
  put(bytes_, static_cast<uint32_t>(crc32(0, &bytes_[from], static_cast<uInt>(bytes_.size() - from))));
}

void PngRows::pack(const std::vector<unsigned char>& data, int flush) {
  packer_.next_in = const_cast<Bytef*>(data.data()), packer_.avail_in = static_cast<uInt>(data.size());
  do {
    const size_t held = packed_.size();
    packed_.resize(kChunk);
    packer_.next_out = &packed_[held], packer_.avail_out = static_cast<uInt>(kChunk - held);
    deflate(&packer_, flush);
    packed_.resize(kChunk - packer_.avail_out);
    if (packer_.avail_out > 0) return;
    chunk("IDAT", packed_.data(), packed_.size());
    packed_.clear();
  } while (true);
}

Result<std::unique_ptr<ImageRows>> open_png(const std::string& path, int width, int height, int channels,
                                            PixelType type) {
  if (channels < 1 || channels > kMaxChannels)
    return failure(ErrorKind::kOutput,
                   fill(tr("an image of {width} x {height} x {channels} channels cannot be written"),
                        arg("width", width), arg("height", height), arg("channels", channels)),
                   path);
  errno = 0;
  auto file = std::make_unique<PngFile>(path, width, height, channels, type);
  if (file->is_open()) return std::unique_ptr<ImageRows>(std::move(file));
  return failure(ErrorKind::kOutput, fill(tr("cannot be written: {cause}"), arg("cause", cause_of(errno))), path);
}

Result<void> write_png(const std::string& path, const Image& image, PixelType type) {
  if (Result<void> shape = check_shape(image, kMaxChannels, kMaxValues, path); !shape) return shape;
  const std::vector<unsigned char> bytes = encode_png(image, type);
  return write_file_atomically(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

std::vector<unsigned char> encode_png(const Image& image, PixelType type) {
  if (!check_shape(image, kMaxChannels, kMaxValues, {})) return {};
  PngRows rows(image.width, image.height, image.channels, type);
  rows.add(image.texels);
  rows.finish();
  return rows.take();
}

}  // namespace weftlight::files
