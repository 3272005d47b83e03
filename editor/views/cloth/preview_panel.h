#pragma once
// The cloth preview: shows the renderer's latest picture; drags change the view or the light.

#include <array>
#include <string>

#include "gl/renderer.h"
#include "session/editing/cloth_view.h"
#include "views/common/panel.h"

namespace weftlight::views {

using gl::FrameStats;
using session::ClothView;

/// The ray-traced reference of the comparison.
struct ReferencePicture {
  unsigned texture = 0;  // the reference or the difference, row 0 on top; 0 if there is none yet
  int samples = 0;       // per pixel; 0: a coarse first picture
  float difference = 0;  // relative RMSE of the preview against it, over the cloth
  bool tracing = false;  // a better one is being traced
  std::string problem;
};

/// The picture to show.
struct PreviewPicture {
  unsigned texture = 0;  // 0 if there is none yet
  FrameStats stats;
  float tolerance = 0, budget_ms = 0;  // limits it was drawn with; budget 0: no time limit
  std::string problem;                 // why there is no picture, or what is wrong with the mesh
  bool busy = false;                   // the latest edit is not in the picture yet
  bool refining = false;               // a finer picture of the same design is being drawn
  ReferencePicture reference;
};

/// Fills the rest of the current window. `pane` receives the size of the picture in window pixels.
void draw_preview(const PanelContext& c, const ClothView& view, const PreviewPicture& picture, ImVec2& pane);

}  // namespace weftlight::views
