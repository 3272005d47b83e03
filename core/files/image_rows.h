#pragma once
// An image file that is written band by band, from the top, so that no more of it is in memory than a band.

#include <memory>
#include <string>
#include <vector>

#include "files/files.h"

namespace weftlight::files {

class ImageRows {
 public:
  /// Opens .png or .exr by extension. `channels`: names for an .exr, or none. Null: `problem` says why.
  static std::unique_ptr<ImageRows> open(const std::string& path, int width, int height, int channels, PixelType type,
                                         const std::vector<std::string>& names, std::string& problem);
  ~ImageRows();
  /// The next rows; as wide and with as many channels as the image. Empty: done; else what went wrong.
  std::string add(const Image& band);
  /// After the last row; flushed to the disk.
  std::string close();

 private:
  struct File;
  explicit ImageRows(std::unique_ptr<File> file);
  std::unique_ptr<File> file_;
};

}  // namespace weftlight::files
