#pragma once
// A texture with all mip levels in one file: KTX2 or DDS, 8 bits per channel, uncompressed. Rows of every level are
// written as they are made, so that no level is kept in memory.

#include <memory>
#include <string>

#include "files/files.h"

namespace weftlight::files {

enum class MipContainer { kDds, kKtx2 };
/// ".dds" or ".ktx2".
const char* extension_of(MipContainer container);

class MipFile {
 public:
  /// Level k has max(width >> k, 1) x max(height >> k, 1) texels, down to 1 x 1. One channel stays one; three become
  /// four, opaque. `srgb` is stored in a KTX2; this kind of DDS, which every reader supports, has no field for it.
  /// Sides 1..16384.
  static base::Result<std::unique_ptr<MipFile>> open(const std::string& path, MipContainer container, int width,
                                                     int height, int channels, bool srgb);
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
