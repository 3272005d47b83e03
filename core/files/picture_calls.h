#pragma once
// What the library weftlight_pictures offers: pictures through OpenImageIO. It and the 260 libraries that come with it
// take a quarter of a second of processor time to load, more than all the rest of a start, and most commands and
// windows never read a picture. So they are loaded with the first one (at_runtime/pictures.cpp).

#include <string>
#include <vector>

#include "files/environment.h"
#include "files/files.h"

namespace weftlight::files {

using Names = std::vector<std::string>;

/// The functions of files.h, image_rows.h, scaled.h and environment.h.
struct PictureCalls {
  base::Result<void> (*write_image)(const std::string& path, const Image&, PixelType, const Names&);
  base::Result<ImageSize> (*read_image_size)(const std::string& path);
  base::Result<Image> (*read_image)(const std::string& path, int level);
  std::vector<unsigned char> (*encode_png)(const Image&, PixelType);
  void (*draw_text)(Image&, int x, int y, int size, const std::string&, const std::vector<float>& colour);
  Image (*scaled)(Image, int width, int height);
  base::Result<EnvironmentPicture> (*read_environment)(const std::string& path);
  base::Result<void> (*check_environment)(const std::string& path);
  // An ImageRows of the library, which alone knows what it is.
  base::Result<void*> (*open_rows)(const std::string& path, int width, int height, int channels, PixelType,
                                   const Names&);
  base::Result<void*> (*open_mipmapped_rows)(const std::string& path, int width, int height, const Names&);
  base::Result<void> (*add_rows)(void*, const Image& band, int level);
  base::Result<void> (*close_rows)(void*);
  void (*end_rows)(void*);
};

inline constexpr const char* kPictureLibrary = "weftlight_pictures.so";

}  // namespace weftlight::files
