// Based on: Khronos, KTX File Format 2.0, 2024, and Data Format 1.3 (its basic descriptor block); Microsoft, DDS file
//   layout (the header of DirectX 9, which every reader supports, and that of DirectX 10 for blocks).

#include "files/mip_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <span>
#include <vector>

#include "base/loops.h"
#include "base/text.h"
#include "base/whole_files.h"
#include "files/block_compression.h"
#include "platform/file.h"

namespace weftlight::files {

using base::ErrorKind, base::Result, base::arg, base::cause_of, base::failure, base::fill, base::for_each_job, base::tr;

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

/// How texels stand in the file: in units of `side` x `side` texels and `bytes`, of `channels` channels each.
struct Layout {
  int side = 1, bytes = 1, channels = 1;
  std::optional<BlockFormat> blocks{};
};

Layout layout_of(MipFormat format, int channels) {
  if (!has_blocks(format)) return channels == 1 ? Layout{} : Layout{1, 4, 4};
  const BlockFormat blocks = channels == 1 ? BlockFormat::kBc4 : channels == 2 ? BlockFormat::kBc5 : BlockFormat::kBc7;
  return {4, bytes_of(blocks), channels_of(blocks), blocks};
}

struct Level {
  int width = 0, height = 0, next = 0;  // next: rows taken so far
  uint64_t offset = 0, end = 0;         // end: of what is written
  std::vector<uint8_t> waiting{};       // rows that do not fill a row of blocks yet
};

uint64_t units(int texels, const Layout& layout) {
  return static_cast<uint64_t>((texels + layout.side - 1) / layout.side);
}
uint64_t bytes_of(const Level& l, const Layout& layout) {
  return units(l.width, layout) * units(l.height, layout) * static_cast<uint64_t>(layout.bytes);
}

Bytes dds_header(const std::vector<Level>& levels, const Layout& layout, bool srgb) {
  constexpr uint32_t kCaps = 1, kHeight = 2, kWidth = 4, kPitch = 8, kFormat = 0x1000, kMips = 0x20000,
                     kLinearSize = 0x80000;
  constexpr uint32_t kAlphaPixels = 1, kFourCc = 4, kRgb = 0x40, kLuminance = 0x20000, kDx10 = 0x30315844;
  constexpr uint32_t kComplex = 8, kTexture = 0x1000, kHasMips = 0x400000;
  constexpr uint32_t kBc4 = 80, kBc5 = 83, kBc7 = 98, kBc7Srgb = 99, kTexture2d = 3;
  const bool color = layout.channels == 4;
  Bytes b;
  b.u32(0x20534444u);  // "DDS "
  b.u32(124);
  b.u32(kCaps | kHeight | kWidth | (layout.blocks ? kLinearSize : kPitch) | kFormat | kMips);
  b.u32(static_cast<uint32_t>(levels[0].height)), b.u32(static_cast<uint32_t>(levels[0].width));
  b.u32(layout.blocks ? static_cast<uint32_t>(bytes_of(levels[0], layout))
                      : static_cast<uint32_t>(levels[0].width * layout.bytes));
  b.u32(0), b.u32(static_cast<uint32_t>(levels.size()));
  b.zeros(11);
  b.u32(32);
  if (layout.blocks) {
    b.u32(kFourCc), b.u32(kDx10), b.zeros(5);
  } else {
    b.u32(color ? kRgb | kAlphaPixels : kLuminance), b.u32(0), b.u32(static_cast<uint32_t>(layout.bytes * 8));
    if (color) b.u32(0xFF0000u), b.u32(0xFF00u), b.u32(0xFFu), b.u32(0xFF000000u);
    else b.u32(0xFFu), b.zeros(3);
  }
  b.u32(kComplex | kTexture | kHasMips);
  b.zeros(4);
  if (!layout.blocks) return b;
  b.u32(color ? (srgb ? kBc7Srgb : kBc7) : layout.channels == 2 ? kBc5 : kBc4);
  b.u32(kTexture2d), b.u32(0), b.u32(1), b.u32(0);
  return b;
}

/// A sample of the data format: bits from `first`, `count` of them.
void add_sample(Bytes& b, int first, int count, unsigned channel, uint32_t most) {
  b.u16(static_cast<unsigned>(first)), b.u8(static_cast<unsigned>(count - 1)), b.u8(channel);
  b.zeros(2), b.u32(most);
}

/// The basic descriptor block of the Khronos data format.
Bytes ktx_descriptor(const Layout& layout, bool srgb) {
  constexpr unsigned kVersion = 2, kColors = 1, kBc4 = 131, kBc5 = 132, kBc7 = 134, kPrimaries = 1, kLinear = 1,
                     kSrgb = 2, kAlpha = 15, kAlwaysLinear = 16;
  constexpr int kBc4Bits = 64, kBc7Bits = 128;
  const int samples = !layout.blocks || layout.channels == 2 ? layout.channels : 1;
  const unsigned block = 24 + 16 * static_cast<unsigned>(samples);
  Bytes b;
  b.u32(4 + block);
  b.u32(0), b.u16(kVersion), b.u16(block);
  b.u8(!layout.blocks ? kColors : layout.channels == 4 ? kBc7 : layout.channels == 2 ? kBc5 : kBc4);
  b.u8(kPrimaries), b.u8(srgb ? kSrgb : kLinear), b.u8(0);
  const auto last = static_cast<unsigned>(layout.side - 1);
  b.u8(last), b.u8(last), b.u8(0), b.u8(0);
  b.u8(static_cast<unsigned>(layout.bytes)), b.zeros(1), b.u8(0), b.u8(0), b.u8(0);
  if (layout.blocks) {
    const int bits = layout.channels == 4 ? kBc7Bits : kBc4Bits;
    for (int i = 0; i < samples; ++i) add_sample(b, i * bits, bits, static_cast<unsigned>(i), 0xFFFFFFFFu);
    return b;
  }
  for (int c = 0; c < samples; ++c)
    add_sample(b, 8 * c, 8, c < 3 ? static_cast<unsigned>(c) : kAlpha | (srgb ? kAlwaysLinear : 0u), 255);
  return b;
}

/// The number of the format in Vulkan.
uint32_t vulkan_format(const Layout& layout, bool srgb) {
  constexpr uint32_t kR8 = 9, kR8Srgb = 15, kRgba8 = 37, kRgba8Srgb = 43, kBc4 = 139, kBc5 = 141, kBc7 = 145,
                     kBc7Srgb = 146;
  if (!layout.blocks) return layout.channels == 4 ? (srgb ? kRgba8Srgb : kRgba8) : (srgb ? kR8Srgb : kR8);
  if (layout.channels == 4) return srgb ? kBc7Srgb : kBc7;
  return layout.channels == 2 ? kBc5 : kBc4;
}

Bytes ktx_header(std::vector<Level>& levels, const Layout& layout, bool srgb) {
  constexpr std::array<unsigned, 12> kName{0xAB, 'K', 'T', 'X', ' ', '2', '0', 0xBB, '\r', '\n', 0x1A, '\n'};
  const Bytes descriptor = ktx_descriptor(layout, srgb);
  const auto at = static_cast<uint32_t>(80 + 24 * levels.size());
  const auto whole = static_cast<uint64_t>(std::max(layout.bytes, 4));  // levels begin at multiples of it
  uint64_t end = at + descriptor.size();
  for (size_t k = levels.size(); k-- > 0;)
    levels[k].offset = end = (end + whole - 1) / whole * whole, end += bytes_of(levels[k], layout);
  Bytes b;
  for (const unsigned c : kName) b.u8(c);
  b.u32(vulkan_format(layout, srgb));
  b.u32(1), b.u32(static_cast<uint32_t>(levels[0].width)), b.u32(static_cast<uint32_t>(levels[0].height));
  b.u32(0), b.u32(0), b.u32(1), b.u32(static_cast<uint32_t>(levels.size())), b.u32(0);
  b.u32(at), b.u32(static_cast<uint32_t>(descriptor.size()));
  b.zeros(6);  // no key-value data, no supercompression
  for (const Level& l : levels) b.u64(l.offset), b.u64(bytes_of(l, layout)), b.u64(bytes_of(l, layout));
  Bytes all = b;
  for (const uint8_t v : descriptor.all()) all.u8(v);
  return all;
}

base::Failure not_written(const std::string& path) {
  return failure(ErrorKind::kOutput, fill(tr("cannot be written: {cause}"), arg("cause", cause_of(errno))), path);
}

/// Texels as bytes of the layout's channels; those that the image lacks are 255.
std::vector<uint8_t> stored_texels(const Image& rows, const Layout& layout, bool blue_first) {
  const size_t texels = static_cast<size_t>(rows.width) * static_cast<size_t>(rows.height);
  const auto stored = static_cast<size_t>(layout.channels), channels = static_cast<size_t>(rows.channels);
  std::vector<uint8_t> bytes(texels * stored, 255);
  for (size_t i = 0; i < texels; ++i) {
    for (size_t c = 0; c < channels; ++c) {
      const float v = rows.texels[i * channels + c];
      const size_t at = blue_first && c < 3 ? 2 - c : c;
      bytes[i * stored + at] = static_cast<uint8_t>(v > 0 ? std::min(v, 1.0f) * 255 + 0.5f : 0.0f);
    }
  }
  return bytes;
}

/// The texels of a block; beyond the edges those at the edge are repeated.
template <size_t kBytes>
std::array<uint8_t, kBytes> block_at(std::span<const uint8_t> rows, int width, int x0, int y0, int channels,
                                     int first) {
  const int height = static_cast<int>(rows.size()) / (width * channels);
  std::array<uint8_t, kBytes> block{};
  constexpr size_t kChannels = kBytes / 16;
  for (size_t i = 0; i < 16; ++i) {
    const int x = std::min(x0 + static_cast<int>(i % 4), width - 1);
    const int y = std::min(y0 + static_cast<int>(i / 4), height - 1);
    for (size_t c = 0; c < kChannels; ++c)
      block[kChannels * i + c] = rows[static_cast<size_t>((y * width + x) * channels + first) + c];
  }
  return block;
}

/// One block with its upper left texel there, as bytes.
void add_block(uint8_t* out, std::span<const uint8_t> rows, int width, int x, int y, BlockFormat format) {
  if (format == BlockFormat::kBc7) {
    std::ranges::copy(compress_bc7(block_at<64>(rows, width, x, y, 4, 0)), out);
    return;
  }
  const int channels = channels_of(format);
  for (int c = 0; c < channels; ++c)
    std::ranges::copy(compress_bc4(block_at<16>(rows, width, x, y, channels, c)), out + 8 * c);
}

/// Rows of texels as rows of blocks.
std::vector<uint8_t> compressed(std::span<const uint8_t> rows, int width, const Layout& layout) {
  const int height = static_cast<int>(rows.size()) / (width * layout.channels);
  const size_t across = units(width, layout), down = units(height, layout);
  const size_t row_bytes = across * static_cast<size_t>(layout.bytes);
  std::vector<uint8_t> out(down * row_bytes);
  for_each_job(static_cast<int>(down), [&](int y) {
    for (size_t x = 0; x < across; ++x)
      add_block(out.data() + static_cast<size_t>(y) * row_bytes + x * static_cast<size_t>(layout.bytes), rows, width,
                4 * static_cast<int>(x), 4 * y, *layout.blocks);
  });
  return out;
}

}  // namespace

struct MipFile::File {
  std::string path;
  std::FILE* out = nullptr;
  int channels = 0;  // of the images
  Layout layout;
  bool blue_first = false;
  std::vector<Level> levels;
  ~File() {
    if (out) std::fclose(out);
  }
  bool write(Level& level, std::span<const uint8_t> bytes) {
    const uint64_t offset = level.offset + level.end;
    level.end += bytes.size();
    return std::fseek(out, static_cast<long>(offset), SEEK_SET) == 0 &&
           std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size();
  }
  /// Writes the rows of blocks that are full, and what is left at the end of the level.
  bool write_blocks(Level& level, std::span<const uint8_t> bytes) {
    level.waiting.insert(level.waiting.end(), bytes.begin(), bytes.end());
    const size_t row = static_cast<size_t>(level.width) * static_cast<size_t>(layout.channels);
    const size_t rows = level.waiting.size() / row;
    const size_t whole = level.next == level.height ? rows : rows / 4 * 4;
    if (whole == 0) return true;
    const std::vector<uint8_t> blocks = compressed(std::span(level.waiting).first(whole * row), level.width, layout);
    level.waiting.erase(level.waiting.begin(), level.waiting.begin() + static_cast<std::ptrdiff_t>(whole * row));
    return write(level, blocks);
  }
};

const char* name_of(MipFormat format) { return kMipFormats[static_cast<size_t>(format)].name; }

std::optional<MipFormat> mip_format_named(std::string_view name) {
  const auto found = std::ranges::find(kMipFormats, name, &NamedMipFormat::name);
  return found == kMipFormats.end() ? std::nullopt : std::optional(found->format);
}

const char* extension_of(MipFormat format) { return is_dds(format) ? ".dds" : ".ktx2"; }

MipFile::MipFile(std::unique_ptr<File> file) : file_(std::move(file)) {}
MipFile::~MipFile() = default;

Result<std::unique_ptr<MipFile>> MipFile::open(const std::string& path, MipFormat format, int width, int height,
                                               int channels, bool srgb) {
  const bool fits = width >= 1 && width <= kMaxSide && height >= 1 && height <= kMaxSide;
  if (!fits || channels < 1 || channels > 4 || !holds(format, channels))
    return failure(ErrorKind::kOutput,
                   fill(tr("an image of {width} x {height} x {channels} channels cannot be written"),
                        arg("width", width), arg("height", height), arg("channels", channels)),
                   path);
  auto file = std::make_unique<File>();
  file->path = path, file->channels = channels, file->layout = layout_of(format, channels);
  file->blue_first = format == MipFormat::kDds && channels > 1;
  const int count = std::bit_width(static_cast<unsigned>(std::max(width, height)));
  for (int k = 0; k < count; ++k) file->levels.push_back({std::max(width >> k, 1), std::max(height >> k, 1)});
  Bytes header;
  if (is_dds(format)) {
    header = dds_header(file->levels, file->layout, srgb);
    uint64_t end = header.size();
    for (Level& l : file->levels) l.offset = end, end += bytes_of(l, file->layout);
  } else {
    header = ktx_header(file->levels, file->layout, srgb);
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
  const std::vector<uint8_t> bytes = stored_texels(rows, f.layout, f.blue_first);
  l.next += rows.height;
  if (!(f.layout.blocks ? f.write_blocks(l, bytes) : f.write(l, bytes))) return not_written(f.path);
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
