#pragma once
// Traces the reference picture of a still view on a thread of its own, at rising samples, and lays it
// beside the preview.

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "files/files.h"
#include "session/names.h"
#include "upload/reference_scene.h"

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

struct Comparison {
  int width = 0, height = 0;
  int samples = 0;                              // a pixel; 0: a coarse first picture
  std::vector<uint32_t> reference, difference;  // RGBA8, row 0 on top; the difference kDifferenceScale times
  float relative_error = 0;  // RMSE of the preview over the reference's RMS, linear light, over the cloth
  bool finished = false;
  std::string problem;
};
/// What the window shows of a traced picture. `around` and `preview` as in TraceJob.
Comparison compare(Image around, const Image& preview, const TracedImage& traced, float exposure_ev);

class ReferenceTracer {
 public:
  ReferenceTracer();
  ~ReferenceTracer();
  ReferenceTracer(const ReferenceTracer&) = delete;
  ReferenceTracer& operator=(const ReferenceTracer&) = delete;

  /// Leaves what it is at.
  void start(TraceJob job);
  void stop();
  bool busy() const;
  /// What is new since the last call.
  std::optional<Comparison> take();

 private:
  void work();
  void trace(const TraceJob& job, const std::stop_token& stop);
  void publish(Comparison made, const std::stop_token& stop);

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<TraceJob> waiting_;
  std::optional<Comparison> made_;
  std::stop_source current_;
  bool working_ = false, leaving_ = false;
  ReferenceScene scene_;
  std::thread thread_;
};

}  // namespace weftlight::session
