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
base::Result<void> add_rows(void* rows, const Image& band) { return static_cast<ImageRows*>(rows)->add(band); }
base::Result<void> close_rows(void* rows) { return static_cast<ImageRows*>(rows)->close(); }
void end_rows(void* rows) { delete static_cast<ImageRows*>(rows); }

}  // namespace
}  // namespace weftlight::files

extern "C" const weftlight::files::PictureCalls* weftlight_picture_calls() {
  using namespace weftlight;
  static constexpr files::PictureCalls kCalls{
      files::write_image,       files::write_mipmapped_exr, files::read_image_size, files::read_image,
      files::encode_png,        files::draw_text,           files::scaled,          files::read_environment,
      files::check_environment, files::open_rows,           files::add_rows,        files::close_rows,
      files::end_rows};
  return &kCalls;
}
