// Pictures through the library weftlight_pictures (picture_calls.h), which is loaded with the first of them.

#include <atomic>
#include <utility>

#include "base/library_file.h"
#include "base/text.h"
#include "files/environment.h"
#include "files/image_rows.h"
#include "files/picture_calls.h"
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

struct ImageRows::File {
  File() = default;
  ~File() {
    if (rows != nullptr) (*calls())->end_rows(rows);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  void* rows = nullptr;  // of the library
};

ImageRows::ImageRows(std::unique_ptr<File> file) : file_(std::move(file)) {}
ImageRows::~ImageRows() = default;

Result<std::unique_ptr<ImageRows>> ImageRows::open(const std::string& path, int width, int height, int channels,
                                                   PixelType type, const Names& names) {
  const auto library = calls();
  if (!library) return failed(library);
  auto file = std::make_unique<File>();  // before there are rows, which an end of memory would lose
  const Result<void*> rows = (*library)->open_rows(path, width, height, channels, type, names);
  if (!rows) return failed(rows);
  file->rows = *rows;
  return std::unique_ptr<ImageRows>(new ImageRows(std::move(file)));
}

Result<std::unique_ptr<ImageRows>> ImageRows::open_mipmapped(const std::string& path, int width, int height,
                                                             const Names& names) {
  const auto library = calls();
  if (!library) return failed(library);
  auto file = std::make_unique<File>();
  const Result<void*> rows = (*library)->open_mipmapped_rows(path, width, height, names);
  if (!rows) return failed(rows);
  file->rows = *rows;
  return std::unique_ptr<ImageRows>(new ImageRows(std::move(file)));
}

Result<void> ImageRows::add(const Image& band, int level) { return (*calls())->add_rows(file_->rows, band, level); }
Result<void> ImageRows::close() { return (*calls())->close_rows(file_->rows); }

Result<void> write_image(const std::string& path, const Image& image, PixelType type, const Names& channels) {
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

std::vector<unsigned char> encode_png(const Image& image, PixelType type) {
  const auto library = calls();
  return library ? (*library)->encode_png(image, type) : std::vector<unsigned char>();
}

void draw_text(Image& image, int x, int y, int size, const std::string& text, const std::vector<float>& colour) {
  if (const auto library = calls()) (*library)->draw_text(image, x, y, size, text, colour);
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
