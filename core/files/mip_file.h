#pragma once
// A texture with its mips in one file, as graphics cards take it: KTX2 or DDS, 8 bits a channel, not compressed. Rows
// of every level come as they are made, so that no level is held in memory.

#include <memory>
#include <string>

#include "files/files.h"
#include "files/names.h"

namespace weftlight::files {

enum class MipContainer { kDds, kKtx2 };
/// ".dds" or ".ktx2".
const char* extension_of(MipContainer container);

class MipFile {
 public:
  /// Level k has max(width >> k, 1) x max(height >> k, 1) texels, down to 1 x 1. One channel stays one; three become
  /// four, opaque. `srgb` is said in a KTX2; a DDS of this kind, which every reader takes, has no place for it. Sides
  /// 1..16384. Null: `problem` says why.
  static std::unique_ptr<MipFile> open(const std::string& path, MipContainer container, int width, int height,
                                       int channels, bool srgb, std::string& problem);
  ~MipFile();
  int levels() const;
  /// The next rows of a level, from the top; the levels in any order. Empty: done; else what went wrong.
  std::string add(int level, const Image& rows);
  /// After the last row of all levels; flushed to the disk.
  std::string close();

 private:
  struct File;
  explicit MipFile(std::unique_ptr<File> file);
  std::unique_ptr<File> file_;
};

}  // namespace weftlight::files
