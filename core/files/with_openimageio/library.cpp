// The one function that the library weftlight_pictures shows.

#include "files/image_rows.h"
#include "files/picture_calls.h"
#include "files/scaled.h"

namespace weftlight::files {
namespace {

base::Result<void*> open_rows(const std::string& path, int width, int height, int channels, PixelType type,
                              const Names& names) {
  auto rows = ImageRows::open(path, width, height, channels, type, names);
  if (!rows) return base::failed(rows);
  return static_cast<void*>(rows->release());
}
base::Result<void*> open_mipmapped_rows(const std::string& path, int width, int height, const Names& names) {
  auto rows = ImageRows::open_mipmapped(path, width, height, names);
  if (!rows) return base::failed(rows);
  return static_cast<void*>(rows->release());
}
base::Result<void> add_rows(void* rows, const Image& band, int level) {
  return static_cast<ImageRows*>(rows)->add(band, level);
}
base::Result<void> close_rows(void* rows) { return static_cast<ImageRows*>(rows)->close(); }
void end_rows(void* rows) { delete static_cast<ImageRows*>(rows); }

}  // namespace

extern "C" const PictureCalls* weftlight_picture_calls() {
  static constexpr PictureCalls kCalls{
      write_image,       read_image_size, read_image,          encode_png, draw_text,  scaled,  read_environment,
      check_environment, open_rows,       open_mipmapped_rows, add_rows,   close_rows, end_rows};
  return &kCalls;
}

}  // namespace weftlight::files
