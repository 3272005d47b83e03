#pragma once
// What the library weftlight_pictures offers: pictures through OpenImageIO. It and the 260 libraries that come with it
// take a quarter of a second of processor time to load, more than all the rest of a start, and most commands and
// windows read no picture and write none but PNG (png_rows.h). So they are loaded with the first other picture
// (at_runtime/pictures.cpp).

#include <memory>
#include <string>
#include <vector>

#include "files/environment.h"
#include "files/files.h"
#include "files/image_rows.h"

namespace weftlight::files {

using Names = std::vector<std::string>;

/// Functions of files.h, image_rows.h, scaled.h and environment.h.
struct PictureCalls {
  base::Result<void> (*write_image)(const std::string& path, const Image&, PixelType, const Names&);
  base::Result<ImageSize> (*read_image_size)(const std::string& path);
  base::Result<Image> (*read_image)(const std::string& path, int level);
  Image (*scaled)(Image, int width, int height);
  base::Result<EnvironmentPicture> (*read_environment)(const std::string& path);
  base::Result<void> (*check_environment)(const std::string& path);
  base::Result<std::unique_ptr<ImageRows>> (*open_rows)(const std::string& path, int width, int height, int channels,
                                                        PixelType, const Names&);
  base::Result<std::unique_ptr<ImageRows>> (*open_mipmapped_rows)(const std::string& path, int width, int height,
                                                                  const Names&);
};

inline constexpr const char* kPictureLibrary = "weftlight_pictures.so";

}  // namespace weftlight::files
