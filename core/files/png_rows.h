#pragma once
// PNG, written by the program itself: a library for pictures of all kinds takes longer to load than a set of textures
// in PNG takes to write.

#include <zlib.h>

#include <string>
#include <vector>

#include "files/image_rows.h"

namespace weftlight::files {

/// Whether a file of this name is a PNG, whose functions these are.
bool is_png(const std::string& path);
base::Result<std::unique_ptr<ImageRows>> open_png(const std::string& path, int width, int height, int channels,
                                                  PixelType type);
base::Result<void> write_png(const std::string& path, const Image& image, PixelType type);

/// The bytes of a PNG, made as rows come. Types of floating point become 16 bits.
class PngRows {
 public:
  PngRows(int width, int height, int channels, PixelType type);
  ~PngRows();
  PngRows(const PngRows&) = delete;
  PngRows& operator=(const PngRows&) = delete;

  void add(const std::vector<float>& texels);
  /// After the last row.
  void finish();
  /// The bytes made since it was called last.
  std::vector<unsigned char> take();

 private:
  void chunk(std::string_view name, const unsigned char* data, size_t size);
  void pack(const std::vector<unsigned char>& data, int flush);

  size_t values_;  // of a row
  bool wide_ = false;
  std::vector<unsigned char> last_, now_, filtered_, bytes_;
  std::vector<unsigned char> packed_;  // of the next chunk
  z_stream packer_{};
};

}  // namespace weftlight::files
