// Pictures through the library weftlight_pictures (picture_calls.h), which is loaded with the first of them. A PNG is
// written without it.

#include <atomic>
#include <utility>

#include "base/library_file.h"
#include "base/text.h"
#include "files/environment.h"
#include "files/image_rows.h"
#include "files/picture_calls.h"
#include "files/png_rows.h"
#include "files/scaled.h"
#include "platform/shared_library.h"

namespace weftlight::files {

using base::ErrorKind, base::Result, base::arg, base::failed, base::failure, base::fill, base::tr;

namespace {

Result<const PictureCalls*> loaded_calls() {
  using Calls = const PictureCalls*();
  const std::string path = base::library_file(kPictureLibrary);
  std::string problem;
  auto* const calls = reinterpret_cast<Calls*>(platform::function_of_library(path, "weftlight_picture_calls", problem));
  if (calls != nullptr) return calls();
  return failure(ErrorKind::kInput, fill(tr("pictures cannot be read or written: {problem}; install Weftlight again"),
                                         arg("problem", problem)));
}

/// Tried again where it failed.
Result<const PictureCalls*> calls() {
  static std::atomic<const PictureCalls*> known = nullptr;
  if (const PictureCalls* there = known) return there;
  Result<const PictureCalls*> now = loaded_calls();
  if (now) known = *now;
  return now;
}

}  // namespace

void load_pictures() { static_cast<void>(calls()); }

Result<std::unique_ptr<ImageRows>> ImageRows::open(const std::string& path, int width, int height, int channels,
                                                   PixelType type, const Names& names) {
  if (is_png(path)) return open_png(path, width, height, channels, type);
  const auto library = calls();
  if (!library) return failed(library);
  return (*library)->open_rows(path, width, height, channels, type, names);
}

Result<std::unique_ptr<ImageRows>> ImageRows::open_mipmapped(const std::string& path, int width, int height,
                                                             const Names& names) {
  const auto library = calls();
  if (!library) return failed(library);
  return (*library)->open_mipmapped_rows(path, width, height, names);
}

Result<void> write_image(const std::string& path, const Image& image, PixelType type, const Names& channels) {
  if (is_png(path)) return write_png(path, image, type);
  const auto library = calls();
  if (!library) return failed(library);
  return (*library)->write_image(path, image, type, channels);
}

Result<ImageSize> read_image_size(const std::string& path) {
  const auto library = calls();
  if (!library) return failed(library);
  return (*library)->read_image_size(path);
}

Result<Image> read_image(const std::string& path, int level) {
  const auto library = calls();
  if (!library) return failed(library);
  return (*library)->read_image(path, level);
}

Image scaled(Image image, int width, int height) {
  if (const auto library = calls()) return (*library)->scaled(std::move(image), width, height);
  const size_t values = static_cast<size_t>(width) * static_cast<size_t>(height) * static_cast<size_t>(image.channels);
  return {width, height, image.channels, std::vector<float>(values)};
}

Result<EnvironmentPicture> read_environment(const std::string& path) {
  const auto library = calls();
  if (!library) return failed(library);
  return (*library)->read_environment(path);
}

Result<void> check_environment(const std::string& path) {
  const auto library = calls();
  if (!library) return failed(library);
  return (*library)->check_environment(path);
}

}  // namespace weftlight::files
