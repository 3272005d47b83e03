// The one function that the library weftlight_pictures shows.

#include "files/image_rows.h"
#include "files/picture_calls.h"
#include "files/scaled.h"

namespace weftlight::files {

extern "C" const PictureCalls* weftlight_picture_calls() {
  static constexpr PictureCalls kCalls{write_image,      read_image_size,   read_image,      scaled,
                                       read_environment, check_environment, ImageRows::open, ImageRows::open_mipmapped};
  return &kCalls;
}

}  // namespace weftlight::files
