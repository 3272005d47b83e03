#pragma once
// An image file that is written band by band from the top, so that only one band is in memory.

#include <memory>
#include <string>
#include <vector>

#include "files/files.h"

namespace weftlight::files {

class ImageRows {
 public:
  /// Opens .png or .exr by extension. `names`: of the channels of an .exr, or none.
  static base::Result<std::unique_ptr<ImageRows>> open(const std::string& path, int width, int height, int channels,
                                                       PixelType type, const std::vector<std::string>& names);
  ~ImageRows();
  /// Writes the next rows; they have the width and channels of the image.
  base::Result<void> add(const Image& band);
  /// Call it after the last row. On the disk it is when it is put in place (platform/durable_file.h).
  base::Result<void> close();

 private:
  struct File;
  explicit ImageRows(std::unique_ptr<File> file);
  std::unique_ptr<File> file_;
};

}  // namespace weftlight::files
