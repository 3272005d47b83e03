// Based on: Khronos, KTX File Format 2.0, 2024, and Data Format 1.3 (its basic descriptor block); Microsoft, DDS file
//   layout (the header of DirectX 9, which every reader supports).

#include "files/mip_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "base/text.h"
#include "base/whole_files.h"
#include "platform/file.h"

namespace weftlight::files {

using base::ErrorKind, base::Result, base::arg, base::cause_of, base::failure, base::fill, base::tr;

namespace {

constexpr int kMaxSide = 16384;  // with all levels 1.4 GiB, within a long of every system

/// A sequence of little-endian numbers.
class Bytes {
 public:
  void u8(unsigned v) { bytes_.push_back(static_cast<uint8_t>(v)); }
  void u16(unsigned v) { u8(v & 255), u8(v >> 8); }
  void u32(uint32_t v) { u16(v & 0xFFFF), u16(v >> 16); }
  void u64(uint64_t v) { u32(static_cast<uint32_t>(v)), u32(static_cast<uint32_t>(v >> 32)); }
  void zeros(int words) {
    for (int i = 0; i < words; ++i) u32(0);
  }
  const std::vector<uint8_t>& all() const { return bytes_; }
  size_t size() const { return bytes_.size(); }

 private:
  std::vector<uint8_t> bytes_;
};

struct Level {
  int width = 0, height = 0, next = 0;  // next: rows written so far
  uint64_t offset = 0;
};

uint64_t bytes_of(const Level& l, int stored) { return static_cast<uint64_t>(l.width) * l.height * stored; }

Bytes dds_header(const std::vector<Level>& levels, int stored) {
  constexpr uint32_t kCaps = 1, kHeight = 2, kWidth = 4, kPitch = 8, kFormat = 0x1000, kMips = 0x20000;
  constexpr uint32_t kAlphaPixels = 1, kRgb = 0x40, kLuminance = 0x20000;
  constexpr uint32_t kComplex = 8, kTexture = 0x1000, kHasMips = 0x400000;
  Bytes b;
  b.u32(0x20534444u);  // "DDS "
  b.u32(124);
  b.u32(kCaps | kHeight | kWidth | kPitch | kFormat | kMips);
  b.u32(static_cast<uint32_t>(levels[0].height)), b.u32(static_cast<uint32_t>(levels[0].width));
  b.u32(static_cast<uint32_t>(levels[0].width * stored));
  b.u32(0), b.u32(static_cast<uint32_t>(levels.size()));
  b.zeros(11);
  b.u32(32), b.u32(stored == 4 ? kRgb | kAlphaPixels : kLuminance), b.u32(0);
  b.u32(static_cast<uint32_t>(stored * 8));
  if (stored == 4) b.u32(0xFF0000u), b.u32(0xFF00u), b.u32(0xFFu), b.u32(0xFF000000u);
  else b.u32(0xFFu), b.zeros(3);
  b.u32(kComplex | kTexture | kHasMips);
  b.zeros(4);
  return b;
}

/// The basic descriptor block of the Khronos data format.
Bytes ktx_descriptor(int stored, bool srgb) {
  constexpr unsigned kVersion = 2, kColourModel = 1, kPrimaries = 1, kLinear = 1, kSrgb = 2, kAlpha = 15,
                     kAlwaysLinear = 16;
  const unsigned block = 24 + 16 * static_cast<unsigned>(stored);
  Bytes b;
  b.u32(4 + block);
  b.u32(0), b.u16(kVersion), b.u16(block);
  b.u8(kColourModel), b.u8(kPrimaries), b.u8(srgb ? kSrgb : kLinear), b.u8(0);
  b.u32(0);  // texel blocks of 1 x 1
  b.u8(static_cast<unsigned>(stored)), b.zeros(1), b.u8(0), b.u8(0), b.u8(0);
  for (int c = 0; c < stored; ++c) {
    b.u16(static_cast<unsigned>(8 * c)), b.u8(7);
    b.u8(c < 3 ? static_cast<unsigned>(c) : kAlpha | (srgb ? kAlwaysLinear : 0u));
    b.zeros(2), b.u32(255);
  }
  return b;
}

Bytes ktx_header(std::vector<Level>& levels, int stored, bool srgb) {
  constexpr uint32_t kR8 = 9, kR8Srgb = 15, kRgba8 = 37, kRgba8Srgb = 43;
  constexpr std::array<unsigned, 12> kName{0xAB, 'K', 'T', 'X', ' ', '2', '0', 0xBB, '\r', '\n', 0x1A, '\n'};
  const Bytes descriptor = ktx_descriptor(stored, srgb);
  const auto at = static_cast<uint32_t>(80 + 24 * levels.size());
  uint64_t end = at + descriptor.size();
  for (size_t k = levels.size(); k-- > 0;)
    levels[k].offset = end = (end + 3) / 4 * 4, end += bytes_of(levels[k], stored);
  Bytes b;
  for (const unsigned c : kName) b.u8(c);
  b.u32(stored == 4 ? (srgb ? kRgba8Srgb : kRgba8) : (srgb ? kR8Srgb : kR8));
  b.u32(1), b.u32(static_cast<uint32_t>(levels[0].width)), b.u32(static_cast<uint32_t>(levels[0].height));
  b.u32(0), b.u32(0), b.u32(1), b.u32(static_cast<uint32_t>(levels.size())), b.u32(0);
  b.u32(at), b.u32(static_cast<uint32_t>(descriptor.size()));
  b.zeros(6);  // no key-value data, no supercompression
  for (const Level& l : levels) b.u64(l.offset), b.u64(bytes_of(l, stored)), b.u64(bytes_of(l, stored));
  Bytes all = b;
  for (const uint8_t v : descriptor.all()) all.u8(v);
  return all;
}

base::Failure not_written(const std::string& path) {
  return failure(ErrorKind::kOutput, fill(tr("cannot be written: {cause}"), arg("cause", cause_of(errno))), path);
}

}  // namespace

struct MipFile::File {
  std::string path;
  std::FILE* out = nullptr;
  int channels = 0, stored = 0;  // of the images; channels in the file
  bool blue_first = false;
  std::vector<Level> levels;
  ~File() {
    if (out) std::fclose(out);
  }
};

const char* extension_of(MipContainer container) { return container == MipContainer::kDds ? ".dds" : ".ktx2"; }

MipFile::MipFile(std::unique_ptr<File> file) : file_(std::move(file)) {}
MipFile::~MipFile() = default;

Result<std::unique_ptr<MipFile>> MipFile::open(const std::string& path, MipContainer container, int width, int height,
                                               int channels, bool srgb) {
  const bool fits = width >= 1 && width <= kMaxSide && height >= 1 && height <= kMaxSide;
  if (!fits || (channels != 1 && channels != 3 && channels != 4))
    return failure(ErrorKind::kOutput,
                   fill(tr("an image of {width} x {height} x {channels} channels cannot be written"),
                        arg("width", width), arg("height", height), arg("channels", channels)),
                   path);
  auto file = std::make_unique<File>();
  file->path = path, file->channels = channels, file->stored = channels == 1 ? 1 : 4;
  file->blue_first = container == MipContainer::kDds && channels > 1;
  const int count = std::bit_width(static_cast<unsigned>(std::max(width, height)));
  for (int k = 0; k < count; ++k) file->levels.push_back({std::max(width >> k, 1), std::max(height >> k, 1), 0, 0});
  Bytes header;
  if (container == MipContainer::kDds) {
    header = dds_header(file->levels, file->stored);
    uint64_t end = header.size();
    for (Level& l : file->levels) l.offset = end, end += bytes_of(l, file->stored);
  } else {
    header = ktx_header(file->levels, file->stored, srgb);
  }
  file->out = platform::open_stream(path, "wb");
  if (!file->out || std::fwrite(header.all().data(), 1, header.size(), file->out) != header.size())
    return not_written(path);
  return std::unique_ptr<MipFile>(new MipFile(std::move(file)));
}

int MipFile::levels() const { return static_cast<int>(file_->levels.size()); }

Result<void> MipFile::add(int level, const Image& rows) {
  File& f = *file_;
  if (level < 0 || level >= levels()) return failure(ErrorKind::kOutput, tr("has no such mip level"), f.path);
  Level& l = f.levels[static_cast<size_t>(level)];
  if (rows.width != l.width || rows.channels != f.channels || l.next + rows.height > l.height)
    return failure(ErrorKind::kOutput, tr("rows do not fit the mip level"), f.path);
  const size_t texels = static_cast<size_t>(rows.width) * static_cast<size_t>(rows.height);
  const auto stored = static_cast<size_t>(f.stored), channels = static_cast<size_t>(f.channels);
  std::vector<uint8_t> bytes(texels * stored, 255);
  for (size_t i = 0; i < texels; ++i) {
    for (size_t c = 0; c < channels; ++c) {
      const float v = rows.texels[i * channels + c];
      const size_t at = f.blue_first && c < 3 ? 2 - c : c;
      bytes[i * stored + at] = static_cast<uint8_t>(v > 0 ? std::min(v, 1.0f) * 255 + 0.5f : 0.0f);
    }
  }
  const uint64_t offset = l.offset + static_cast<uint64_t>(l.next) * static_cast<uint64_t>(l.width) * stored;
  l.next += rows.height;
  const bool written = std::fseek(f.out, static_cast<long>(offset), SEEK_SET) == 0 &&
                       std::fwrite(bytes.data(), 1, bytes.size(), f.out) == bytes.size();
  if (!written) return not_written(f.path);
  return {};
}

Result<void> MipFile::close() {
  File& f = *file_;
  for (const Level& l : f.levels)
    if (l.next != l.height) return failure(ErrorKind::kOutput, tr("rows of a mip level are missing"), f.path);
  const bool closed = std::fclose(f.out) == 0;
  f.out = nullptr;
  if (!closed) return not_written(f.path);
  return {};
}

}  // namespace weftlight::files
