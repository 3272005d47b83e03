#pragma once
// Keeps the picture of the cloth in step with the design: hands designs to the pipeline, draws only when
// something changed, with fewer pixels while it moves and all of them when it rests.

#include <memory>
#include <string>

#include "panels/preview_panel.h"
#include "preview/pipeline.h"
#include "preview/renderer.h"

namespace weftlight {

class PreviewPane {
 public:
  /// Needs the window's GL context.
  PreviewPane();

  void submit(std::shared_ptr<const Design> design);
  /// Takes what the worker finished. True when there is something new to draw.
  bool poll();
  /// Draws if anything changed since the last time. Sizes in pixels; `moving`: a drag goes on.
  void draw(const Scene& scene, const Look& look, int width, int height, bool moving, double now_s);
  /// Seconds until poll or draw has something to do; negative: only after an event.
  double next_s(double now_s) const;
  PreviewPicture picture() const;

 private:
  struct Key {
    Scene scene;
    Look look;
    int width = 0, height = 0;
    bool operator==(const Key&) const = default;
  };
  float moving_scale() const;

  std::unique_ptr<Renderer> renderer_;
  Pipeline pipeline_;
  std::string problem_;
  bool has_cloth_ = false, dirty_ = false, busy_ = false;
  Key drawn_;
  float drawn_scale_ = 0;
  double moved_s_ = -1e9, full_ms_ = 0;
  FrameStats stats_;
};

}  // namespace weftlight
