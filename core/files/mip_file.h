#pragma once
// A texture with all mip levels in one file: KTX2 or DDS, 8 bits per channel or in compressed blocks. Rows of every
// level are written as they are made, so that no level is kept in memory.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "files/files.h"

namespace weftlight::files {

/// A container, with texels as they are or in blocks: BC4 of one channel, BC5 of two, BC7 of three and four.
enum class MipFormat { kDds, kKtx2, kDdsBlocks, kKtx2Blocks };
struct NamedMipFormat {
  const char* name;
  MipFormat format;
};
inline constexpr std::array<NamedMipFormat, 4> kMipFormats{{{"dds", MipFormat::kDds},
                                                            {"ktx2", MipFormat::kKtx2},
                                                            {"dds-bc", MipFormat::kDdsBlocks},
                                                            {"ktx2-bc", MipFormat::kKtx2Blocks}}};
const char* name_of(MipFormat format);
std::optional<MipFormat> mip_format_named(std::string_view name);
/// ".dds" or ".ktx2".
const char* extension_of(MipFormat format);
inline bool is_dds(MipFormat format) { return format == MipFormat::kDds || format == MipFormat::kDdsBlocks; }
inline bool has_blocks(MipFormat format) { return format == MipFormat::kDdsBlocks || format == MipFormat::kKtx2Blocks; }
inline MipFormat without_blocks(MipFormat format) { return is_dds(format) ? MipFormat::kDds : MipFormat::kKtx2; }
/// Blocks hold any number of channels from 1 to 4; without them there is no form for two.
inline bool holds(MipFormat format, int channels) { return channels != 2 || has_blocks(format); }

class MipFile {
 public:
  /// Level k has max(width >> k, 1) x max(height >> k, 1) texels, down to 1 x 1. One channel stays one; three become
  /// four, opaque. `srgb` is stored, but for a DDS without blocks: the header that every reader supports has no field
  /// for it. Sides 1..16384.
  static base::Result<std::unique_ptr<MipFile>> open(const std::string& path, MipFormat format, int width, int height,
                                                     int channels, bool srgb);
  ~MipFile();
  int levels() const;
  /// Writes the next rows of a level, from the top; levels in any order.
  base::Result<void> add(int level, const Image& rows);
  /// Call it after the last row of all levels. On the disk it is when it is put in place (platform/durable_file.h).
  base::Result<void> close();

 private:
  struct File;
  explicit MipFile(std::unique_ptr<File> file);
  std::unique_ptr<File> file_;
};

}  // namespace weftlight::files
