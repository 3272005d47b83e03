// Images without OpenImageIO (WEFTLIGHT_OPENIMAGEIO is off), through stb: PNG and JPEG are read, PNG is written
// (png_rows.h). Other formats are refused in words.

#include <algorithm>
#include <filesystem>

#include "base/text.h"
#include "base/whole_files.h"
#include "files/files.h"
#include "files/image_rows.h"
#include "files/image_shape.h"
#include "files/png_rows.h"

#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_FAILURE_USERMSG
#include <stb_image.h>

namespace weftlight::files {

using base::ErrorKind, base::Result, base::arg, base::failed, base::failure, base::fill, base::tr;

namespace {

constexpr int64_t kMaxValues = int64_t{1} << 28;  // 1 GiB of floats

base::Failure other_format(ErrorKind kind, const std::string& path) {
  return failure(kind, tr("this build supports PNG only; give a .png, or use the desktop program"), path);
}

struct FreeTexels {
  void operator()(void* texels) const { stbi_image_free(texels); }
};

Result<std::string> file_bytes(const std::string& path) {
  std::error_code ec;
  if (!std::filesystem::is_regular_file(path, ec)) return failure(ErrorKind::kInput, tr("no such file"), path);
  return base::read_file(path);
}

const stbi_uc* bytes_of(const std::string& file) { return reinterpret_cast<const stbi_uc*>(file.data()); }

base::Failure not_read(const std::string& path) {
  return failure(ErrorKind::kInput,
                 fill(tr("{problem}; this build reads PNG and JPEG"), arg("problem", stbi_failure_reason())), path);
}

}  // namespace

void load_pictures() {}  // they are part of the program

Result<std::unique_ptr<ImageRows>> ImageRows::open(const std::string& path, int width, int height, int channels,
                                                   PixelType type, const std::vector<std::string>& /*names*/) {
  if (is_png(path)) return open_png(path, width, height, channels, type);
  return other_format(ErrorKind::kOutput, path);
}
Result<std::unique_ptr<ImageRows>> ImageRows::open_mipmapped(const std::string& path, int /*width*/, int /*height*/,
                                                             const std::vector<std::string>& /*names*/) {
  return other_format(ErrorKind::kOutput, path);
}

Result<void> write_image(const std::string& path, const Image& image, PixelType type,
                         const std::vector<std::string>& /*channels*/) {
  if (is_png(path)) return write_png(path, image, type);
  return other_format(ErrorKind::kOutput, path);
}

Result<ImageSize> read_image_size(const std::string& path) {
  const Result<std::string> file = file_bytes(path);
  if (!file) return failed(file);
  ImageSize size;
  int channels = 0;
  if (!stbi_info_from_memory(bytes_of(*file), static_cast<int>(file->size()), &size.width, &size.height, &channels))
    return not_read(path);
  return size;
}

Result<Image> read_image(const std::string& path, int level) {
  if (level != 0) return failure(ErrorKind::kInput, fill(tr("has no mip level {level}"), arg("level", level)), path);
  const Result<std::string> file = file_bytes(path);
  if (!file) return failed(file);
  const int size = static_cast<int>(file->size());
  Image image;
  if (!stbi_info_from_memory(bytes_of(*file), size, &image.width, &image.height, &image.channels))
    return not_read(path);
  const int64_t values = int64_t{image.width} * image.height * image.channels;
  if (image.width > kMaxSide || image.height > kMaxSide || values > kMaxValues)
    return failure(ErrorKind::kInput,
                   fill(tr("an image of {width} x {height} x {channels} channels cannot be read; scale it down"),
                        arg("width", image.width), arg("height", image.height), arg("channels", image.channels)),
                   path);
  image.texels.resize(static_cast<size_t>(values));
  const bool wide = stbi_is_16_bit_from_memory(bytes_of(*file), size) != 0;
  const std::unique_ptr<void, FreeTexels> texels(
      wide ? static_cast<void*>(
                 stbi_load_16_from_memory(bytes_of(*file), size, &image.width, &image.height, nullptr, image.channels))
           : static_cast<void*>(
                 stbi_load_from_memory(bytes_of(*file), size, &image.width, &image.height, nullptr, image.channels)));
  if (!texels) return not_read(path);
  const auto fill_from = [&image](const auto* from, float top) {
    std::transform(from, from + image.texels.size(), image.texels.begin(), [top](auto v) { return v / top; });
  };
  if (wide) fill_from(static_cast<const uint16_t*>(texels.get()), 65535.0f);
  else fill_from(static_cast<const uint8_t*>(texels.get()), 255.0f);
  return image;
}

}  // namespace weftlight::files
