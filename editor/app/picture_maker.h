#pragma once
// Draws the picture of the cloth: hands designs to the pipeline, draws only after changes, at a lower resolution while
// it moves and at full resolution at rest. The comparison with the ray-traced picture starts at rest and stops at every
// change. Used by one thread, with its GL context.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "gl/pipeline.h"
#include "gl/renderer.h"
#include "session/files/user_files.h"
#include "session/jobs/reference_tracer.h"

namespace weftlight::app {

using design::Design, design::Look, design::Scene;
using gl::Frame, gl::FrameStats, gl::Pipeline, gl::Renderer;
using session::Compare, session::ReferenceTracer, session::TraceJob;

/// The picture that the window requests.
struct PictureRequest {
  Scene scene;
  Look look;
  int width = 0, height = 0;  // pixels
  bool show_methods = false;
  Compare compare = Compare::kOff;
  float budget_ms = 0;  // time budget of the cloth's pass at rest, which sets the tolerance; 0: tolerance of the look
  bool operator==(const PictureRequest&) const = default;
};

class PictureMaker {
 public:
  static constexpr double kRefineMs = 4000;
  /// Needs a GL context. The pipeline may have its first design already. `refine_ms`: limit of all passes of one
  /// picture.
  explicit PictureMaker(Pipeline& pipeline, double refine_ms = kRefineMs);

  /// `draft`: as for the pipeline.
  void submit(std::shared_ptr<const Design> design, uint64_t draft = 0);
  /// The pipeline has it already.
  void follow(std::shared_ptr<const Design> design);
  /// Takes finished work of the pipeline and the tracer. True if there is something new to show.
  bool poll();
  /// Draws if anything changed since the last call; true if it drew.
  bool draw(const PictureRequest& request, bool moving, double now_s);
  /// Seconds until poll or draw has something to do; negative if only submit or another request can need it.
  double next_s(double now_s) const;

  /// The last picture: RGBA8 with sRGB's encoding, row 0 at the bottom; empty when none was drawn.
  void read(int& width, int& height, std::vector<uint32_t>& pixels) const;
  const FrameStats& stats() const { return stats_; }
  /// The error tolerance of the last picture.
  float tolerance() const { return tolerance_; }
  /// For Compare::kSplit or kDifference; empty while nothing is traced, an error if nothing can be.
  const base::Result<session::PictureComparison>& comparison() const { return comparison_; }
  /// Why there is no picture, or an error of the mesh.
  std::string problem() const {
    return !problem_.empty() ? problem_ : !stats_.cloth ? problem_of(stats_.cloth) : problem_of(pipeline_.made());
  }
  const std::shared_ptr<const Design>& design() const { return design_; }
  /// The one that the picture shows; null before the first.
  std::shared_ptr<const Design> drawn_design() const { return pipeline_.uploaded(); }
  /// True while the newest design is being processed, or its shaders are compiled.
  bool busy() const { return renderer_ && (pipeline_.busy() || stats_.compiling); }
  /// For tests: Renderer::hold_programs.
  void hold_programs(bool held) {
    if (renderer_) renderer_->hold_programs(held);
  }
  /// True if more samples of the threads would refine the resting picture.
  bool can_refine() const;

 private:
  Frame frame_of(const PictureRequest& request) const;
  void begin_passes();
  void draw_pass(const PictureRequest& request, float scale);
  /// The look to draw with: with its own tolerance, or the one that keeps to the time budget.
  Look look_for(const PictureRequest& request);
  float moving_scale() const;
  /// Seconds of rest before the picture is drawn at full resolution.
  double rest_s() const;
  void follow_reference(const PictureRequest& request, bool changed);
  TraceJob job_of(const PictureRequest& request);

  std::string problem_;  // why there is no renderer
  std::unique_ptr<Renderer> renderer_;
  Pipeline& pipeline_;
  double refine_ms_;
  std::shared_ptr<const Design> design_;
  bool has_cloth_ = false, dirty_ = false, busy_ = false;
  PictureRequest drawn_;
  float drawn_scale_ = 0;
  double moved_s_ = -1e9;
  int passes_ = 0, samples_ = 0;              // of the resting picture so far
  int lattice_a_pass_ = 1, all_samples_ = 8;  // updated by the cost of the first picture
  double spent_ms_ = 0;                       // on its passes
  double ms_a_sample_ = 0;                    // cost of a sample in a picture mostly of threads
  double full_ms_ = 0, moving_ms_ = 0;        // cost of the cloth at full resolution, at rest and while moving
  FrameStats stats_;
  float tolerance_ = 0, held_ = 0;  // of the last picture; that of the budget, 0 if unknown
  bool held_used_ = false;          // the resting picture uses held_

  ReferenceTracer tracer_;
  bool traced_ = false;  // the tracer has the drawn picture
  base::Result<session::PictureComparison> comparison_;
};

}  // namespace weftlight::app
