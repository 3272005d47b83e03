#pragma once
// Preview of a texture set before it is written: the lit tile, and every image as colour and by channel, laid out in
// one atlas. Made on a thread of its own.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/tasks.h"
#include "session/jobs/export_plan.h"

namespace weftlight::session {

using design::Design;
using draft::Face;
using texture_set::Alpha, texture_set::TextureSetOptions, texture_set::TextureSize;

/// A rectangle of the atlas, in pixels.
struct PictureRect {
  int x = 0, y = 0, width = 0, height = 0;
};

struct ShownChannel {
  std::string words;
  PictureRect at;  // as greys
};
struct ShownImage {
  std::string file, about;  // "sRGB", "linear"
  PictureRect at;           // its first three channels as colour
  std::vector<ShownChannel> channels;
};

struct ExportPreview {
  int width = 0, height = 0;
  std::vector<uint32_t> pixels;  // RGBA8, row 0 on top
  PictureRect swatch;
  std::vector<ShownImage> images;
  Alpha alpha = Alpha::kOpaque;
  float coverage = 1;
  int64_t texels = 0;         // in each image
  float bytes_per_texel = 0;  // on disk, for one face
};
/// Estimate for a whole set with images of this size.
int64_t bytes_on_disk(const ExportPreview& preview, const TextureSize& size);

struct PreviewSizes {
  int swatch_width = 480, swatch_height = 200;  // pixels
  int side = 96;                                // of an image
  float swatch_mm = 30;                         // of cloth over the width of the swatch
  bool operator==(const PreviewSizes&) const = default;
};

/// Has no images if the draft has no cloth.
ExportPreview export_preview(const Design& design, Face face, const TextureSetOptions& options,
                             const PreviewSizes& sizes, const std::stop_token& stop = {});

class ExportPreviewer {
 public:
  /// `wake` is called on the other thread when a preview is ready.
  ExportPreviewer(std::shared_ptr<const Design> design, std::function<void()> wake);
  /// Starts a preview unless the same one was requested last; drops the one in progress.
  void ask(Face face, const TextureSetOptions& options, const PreviewSizes& sizes);
  /// The preview finished since the last call, or why it could not be made.
  std::optional<base::Result<ExportPreview>> take();
  bool busy() const { return busy_; }

 private:
  std::shared_ptr<const Design> design_;
  std::string asked_;  // key of the last request
  std::optional<base::Result<ExportPreview>> made_;
  bool busy_ = false;
  base::TaskRunner runner_;
};

}  // namespace weftlight::session
