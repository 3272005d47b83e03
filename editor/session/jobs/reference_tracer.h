#pragma once
// Path-traces the reference picture of a still view on its own thread, with a growing sample count, and compares it
// with the preview.

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/tasks.h"
#include "files/files.h"
#include "render_data/reference_scene.h"

namespace weftlight::session {

using design::Design, design::Scene;
using files::Image;
using reference::TracedImage;
using render_data::ReferenceScene;

/// A view of the preview.
struct TraceJob {
  std::shared_ptr<const Design> design;
  Scene scene;  // with the current camera
  float exposure_ev = 0;
  Image around;   // the preview without the cloth
  Image preview;  // the complete preview, of the same size
};

inline constexpr float kDifferenceScale = 4;  // brightness factor of the difference picture

struct PictureComparison {
  int width = 0, height = 0;
  int samples = 0;                              // per pixel; 0 for the coarse first picture
  std::vector<uint32_t> reference, difference;  // RGBA8, row 0 on top; the difference is scaled by kDifferenceScale
  float relative_error = 0;  // RMSE of the preview / RMS of the reference; linear light, over the cloth
  bool finished = false;
};
/// Compares a traced picture with the preview. `around` and `preview` as in TraceJob.
PictureComparison compare(Image around, const Image& preview, const TracedImage& traced, float exposure_ev);

class ReferenceTracer {
 public:
  /// Drops the trace in progress.
  void start(TraceJob job);
  void stop();
  bool busy() const;
  /// The newest result since the last call, or why there is no ray-traced picture.
  std::optional<base::Result<PictureComparison>> take();

 private:
  void trace(const TraceJob& job, const std::stop_token& stop);
  void fail(const base::Error& error, const std::stop_token& stop);
  void publish(base::Result<PictureComparison> made, const std::stop_token& stop);

  mutable std::mutex mutex_;  // guards made_
  std::optional<base::Result<PictureComparison>> made_;
  ReferenceScene scene_;     // used by its tasks only
  base::TaskRunner runner_;  // destroyed first: its tasks use all members above
};

}  // namespace weftlight::session
