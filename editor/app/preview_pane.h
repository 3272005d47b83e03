#pragma once
// Keeps the picture of the cloth in step with the design: hands designs to the pipeline, draws only when
// something changed, with fewer pixels while it moves and all of them when it rests. A comparison with the
// ray-traced picture starts when it rests and is given up at every change.

#include <memory>
#include <string>

#include "app/names.h"
#include "app/reference_tracer.h"
#include "gl/pipeline.h"
#include "gl/renderer.h"
#include "panels/pixel_texture.h"
#include "panels/preview_panel.h"

namespace weftlight::app {

struct PreviewRequest {
  Scene scene;
  Look look;
  int width = 0, height = 0;  // pixels
  bool show_rungs = false;
  Compare compare = Compare::kOff;
  bool operator==(const PreviewRequest&) const = default;
};

class PreviewPane {
 public:
  /// Needs the window's GL context.
  PreviewPane();

  void submit(std::shared_ptr<const Design> design);
  /// Takes what the worker finished. True when there is something new to draw.
  bool poll();
  /// Draws if anything changed since the last time.
  void draw(const PreviewRequest& request, bool moving, double now_s);
  /// Seconds until poll or draw has something to do; negative: only after an event.
  double next_s(double now_s) const;
  PreviewPicture picture() const;

 private:
  Frame frame_of(const PreviewRequest& request) const;
  void draw_pass(const PreviewRequest& request, float scale);
  /// Whether more samples of the threads would make the resting picture finer.
  bool can_refine() const;
  float moving_scale() const;
  /// Still for so long: every pixel is drawn.
  double rest_s() const;
  void follow_reference(const PreviewRequest& request, bool changed);
  TraceJob job_of(const PreviewRequest& request);
  void show_comparison();

  std::string problem_;  // filled while the renderer is made
  std::unique_ptr<Renderer> renderer_;
  Pipeline pipeline_;
  std::shared_ptr<const Design> design_;
  bool has_cloth_ = false, dirty_ = false, busy_ = false;
  PreviewRequest drawn_;
  float drawn_scale_ = 0;
  double moved_s_ = -1e9;
  int passes_ = 0, samples_ = 0;              // of the resting picture, so far
  int samples_a_pass_ = 2, all_samples_ = 8;  // the first picture tells what it costs
  double spent_ms_ = 0;                       // on its passes
  double ms_a_sample_ = 0;                    // of a picture mostly of threads
  double full_ms_ = 0, moving_ms_ = 0;        // the cloth's cost at every pixel, at rest and by the moving programs
  FrameStats stats_;

  ReferenceTracer tracer_;
  bool traced_ = false;  // the tracer was given the picture that is drawn
  Comparison comparison_;
  Compare shown_ = Compare::kOff;
  PixelTexture reference_texture_;
};

}  // namespace weftlight::app
