#pragma once
// Keeps the picture of the cloth in step with the design: hands designs to the pipeline, draws only when
// something changed, with fewer pixels while it moves and all of them when it rests. A comparison with the
// ray-traced picture starts when it rests and is given up at every change. Of one thread, with its GL context.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/names.h"
#include "gl/pipeline.h"
#include "gl/renderer.h"
#include "session/reference_tracer.h"
#include "session/user_files.h"

namespace weftlight::app {

/// What the window wants to see.
struct PictureRequest {
  Scene scene;
  Look look;
  int width = 0, height = 0;  // pixels
  bool show_methods = false;
  Compare compare = Compare::kOff;
  float budget_ms = 0;  // of the cloth's pass at rest: the tolerance that keeps within it; 0: the look's
  bool operator==(const PictureRequest&) const = default;
};

class PictureMaker {
 public:
  /// Needs a GL context. The pipeline may have its first design already.
  explicit PictureMaker(Pipeline& pipeline);

  void submit(std::shared_ptr<const Design> design);
  /// The pipeline has it already.
  void follow(std::shared_ptr<const Design> design);
  /// Takes what the worker and the tracer finished. True when there is something new to show.
  bool poll();
  /// Draws if anything changed since the last time; true when it did.
  bool draw(const PictureRequest& request, bool moving, double now_s);
  /// Seconds until poll or draw has something to do; negative: only after submit or another request.
  double next_s(double now_s) const;

  /// The last picture: RGBA8 with sRGB's encoding, row 0 at the bottom; empty when none was drawn.
  void read(int& width, int& height, std::vector<uint32_t>& pixels) const;
  const FrameStats& stats() const { return stats_; }
  /// What the last picture was drawn with.
  float tolerance() const { return tolerance_; }
  /// Of Compare::kSplit or kDifference; empty while nothing is traced.
  const session::PictureComparison& comparison() const { return comparison_; }
  /// Why there is no picture, or what is wrong with the mesh.
  std::string problem() const {
    return !problem_.empty() ? problem_ : !stats_.problem.empty() ? stats_.problem : pipeline_.problem();
  }
  const std::shared_ptr<const Design>& design() const { return design_; }
  /// The newest design is still being worked on.
  bool busy() const { return renderer_ && pipeline_.busy(); }
  /// Whether more samples of the threads would make the resting picture finer.
  bool can_refine() const;

 private:
  Frame frame_of(const PictureRequest& request) const;
  void begin_passes();
  void draw_pass(const PictureRequest& request, float scale);
  /// The look to draw with: by its own tolerance, or by what the last picture took.
  Look look_for(const PictureRequest& request);
  float moving_scale() const;
  /// Still for so long: every pixel is drawn.
  double rest_s() const;
  void follow_reference(const PictureRequest& request, bool changed);
  TraceJob job_of(const PictureRequest& request);

  std::string problem_;  // filled while the renderer is made
  std::unique_ptr<Renderer> renderer_;
  Pipeline& pipeline_;
  std::shared_ptr<const Design> design_;
  bool has_cloth_ = false, dirty_ = false, busy_ = false;
  PictureRequest drawn_;
  float drawn_scale_ = 0;
  double moved_s_ = -1e9;
  int passes_ = 0, samples_ = 0;              // of the resting picture, so far
  int lattice_a_pass_ = 1, all_samples_ = 8;  // the first picture tells what it costs
  double spent_ms_ = 0;                       // on its passes
  double ms_a_sample_ = 0;                    // of a picture mostly of threads
  double full_ms_ = 0, moving_ms_ = 0;        // the cloth's cost at every pixel, at rest and by the moving programs
  FrameStats stats_;
  float tolerance_ = 0, held_ = 0;  // of the last picture; within the budget, 0: not known yet
  bool held_used_ = false;          // the resting picture has it

  ReferenceTracer tracer_;
  bool traced_ = false;  // the tracer was given the picture that is drawn
  session::PictureComparison comparison_;
};

}  // namespace weftlight::app
