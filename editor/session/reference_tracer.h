#pragma once
// Traces the reference picture of a still view on a thread of its own, at rising samples, and lays it
// beside the preview.

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/worker.h"
#include "files/files.h"
#include "render_data/reference_scene.h"
#include "session/names.h"

namespace weftlight::session {

/// A view of the preview.
struct TraceJob {
  std::shared_ptr<const Design> design;
  Scene scene;  // with the camera as it is turned
  float exposure_ev = 0;
  Image around;   // the preview without its cloth
  Image preview;  // the whole preview; of the same size
};

inline constexpr float kDifferenceScale = 4;  // the picture of the difference is this much brighter

struct PictureComparison {
  int width = 0, height = 0;
  int samples = 0;                              // a pixel; 0: a coarse first picture
  std::vector<uint32_t> reference, difference;  // RGBA8, row 0 on top; the difference kDifferenceScale times
  float relative_error = 0;  // RMSE of the preview over the reference's RMS, linear light, over the cloth
  bool finished = false;
  std::string problem;
};
/// What the window shows of a traced picture. `around` and `preview` as in TraceJob.
PictureComparison compare(Image around, const Image& preview, const TracedImage& traced, float exposure_ev);

class ReferenceTracer {
 public:
  /// Leaves what it is at.
  void start(TraceJob job);
  void stop();
  bool busy() const;
  /// What is new since the last call.
  std::optional<PictureComparison> take();

 private:
  void trace(const TraceJob& job, const std::stop_token& stop);
  void publish(PictureComparison made, const std::stop_token& stop);

  mutable std::mutex mutex_;  // of what is made
  std::optional<PictureComparison> made_;
  ReferenceScene scene_;  // the worker's
  Worker worker_;         // the last to be made and the first to go: its jobs use all of the above
};

}  // namespace weftlight::session
