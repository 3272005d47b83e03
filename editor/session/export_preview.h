#pragma once
// A texture set as the window shows it before it is written: the lit tile, and every image whole and by its channels,
// laid out in one picture. Made on a thread of its own.

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/worker.h"
#include "session/export_plan.h"
#include "session/names.h"

namespace weftlight::session {

/// A rectangle of the picture.
struct PictureRect {
  int x = 0, y = 0, width = 0, height = 0;
};

struct ShownChannel {
  std::string words;
  PictureRect at;  // in greys
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
  int64_t texels = 0;         // of its images
  float bytes_per_texel = 0;  // on the disk, of one face
  std::string problem;        // why there are no images
};
/// Of a whole set of images of this size, about.
int64_t bytes_on_disk(const ExportPreview& preview, const TextureSize& size);

struct PreviewSizes {
  int swatch_width = 480, swatch_height = 200;  // pixels
  int side = 96;                                // of a map
  float swatch_mm = 30;                         // of cloth across the swatch
  bool operator==(const PreviewSizes&) const = default;
};

/// Without images where the draft has no cloth.
ExportPreview export_preview(const Design& design, Face face, const TextureSetOptions& options,
                             const PreviewSizes& sizes, const std::stop_token& stop = {});

class ExportPreviewer {
 public:
  /// `wake`: called from the thread when there is news.
  ExportPreviewer(std::shared_ptr<const Design> design, std::function<void()> wake);
  /// Starts on what it was not asked for yet; leaves what it is at.
  void ask(Face face, const TextureSetOptions& options, const PreviewSizes& sizes);
  /// What is new since the last call.
  std::optional<ExportPreview> take();
  bool busy() const;

 private:
  void fail(const std::string& why);

  std::shared_ptr<const Design> design_;
  std::function<void()> wake_;
  std::string asked_;         // what for, as text
  mutable std::mutex mutex_;  // of the next two
  std::optional<ExportPreview> made_;
  bool busy_ = false;
  base::Worker worker_{[this](const std::string& why, const auto&) { fail(why); }};  // gone before what it writes to
};

}  // namespace weftlight::session
