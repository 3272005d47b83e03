// Any bytes as a picture, and as light around the cloth: what the header claims is checked before memory is taken, a
// picture has the texels of its size, and light is finite. OpenImageIO itself is the system's, without sanitizers.

#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "files/environment.h"
#include "files/files.h"
#include "require.h"

using weftlight::files::EnvironmentPicture, weftlight::files::Image, weftlight::files::ImageSize,
    weftlight::files::check_environment, weftlight::files::read_environment, weftlight::files::read_image,
    weftlight::files::read_image_size;

// OpenImageIO 2.4 loses some bytes with each PNG that is cut short.
extern "C" const char* __asan_default_options() { return "detect_leaks=0"; }

namespace {

std::string extension_of(std::string_view bytes) {
  if (bytes.starts_with("#?")) return ".hdr";
  if (bytes.starts_with("\x76\x2f\x31\x01")) return ".exr";
  if (bytes.starts_with("II") || bytes.starts_with("MM")) return ".tif";
  if (bytes.starts_with("BM")) return ".bmp";
  return ".png";
}

/// A file of this process, rewritten for every input.
std::string scratch_file(const std::string& extension) {
  static const std::string folder = [] {
    std::string made =
        (std::filesystem::temp_directory_path() / ("weftlight-fuzz-" + std::to_string(::getpid()))).string();
    std::filesystem::create_directories(made);
    return made;
  }();
  static const int at_exit = std::atexit([] { std::filesystem::remove_all(folder); });
  (void)at_exit;
  return folder + "/x" + extension;
}

void require_whole(const Image& image) {
  require(image.width > 0 && image.height > 0 && image.channels > 0, "a picture has a size");
  require(image.texels.size() == static_cast<size_t>(image.width) * static_cast<size_t>(image.height) *
                                     static_cast<size_t>(image.channels),
          "there is a texel for every place");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::string path = scratch_file(extension_of(bytes));
  {
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    out.write(bytes.data(), static_cast<std::streamsize>(size));
  }
  const weftlight::base::Result<ImageSize> head = read_image_size(path);
  const weftlight::base::Result<Image> image = read_image(path);
  require(image || !image.error().text.empty(), "a rejection has a reason");
  if (image) {
    require_whole(*image);
    require(head && head->width == image->width && head->height == image->height, "the header tells the size");
  }
  const bool may_be_light = bool(check_environment(path));
  const weftlight::base::Result<EnvironmentPicture> light = read_environment(path);
  require(light || !light.error().text.empty(), "a rejection has a reason");
  require(!light || may_be_light, "what is read has a header that can be used");
  if (light) {
    require_whole(light->picture);
    for (const float v : light->picture.texels) require(std::isfinite(v) && v >= 0, "light is finite, not negative");
  }
  return 0;
}
