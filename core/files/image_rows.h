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
  /// Opens a tiled .exr of half floats with all mip levels: level k has max(width >> k, 1) x max(height >> k, 1)
  /// texels, down to 1 x 1. Of the finest level a row of tiles is in memory, the others are as a whole.
  static base::Result<std::unique_ptr<ImageRows>> open_mipmapped(const std::string& path, int width, int height,
                                                                 const std::vector<std::string>& names);
  virtual ~ImageRows() = default;
  ImageRows(const ImageRows&) = delete;
  ImageRows& operator=(const ImageRows&) = delete;
  /// Writes the next rows of a level; they have its width and the channels of the image.
  virtual base::Result<void> add(const Image& band, int level) = 0;
  base::Result<void> add(const Image& band) { return add(band, 0); }
  /// Call it after the last row. On the disk it is when it is put in place (platform/durable_file.h).
  virtual base::Result<void> close() = 0;

 protected:
  ImageRows() = default;
};

}  // namespace weftlight::files
