#pragma once
// The lit cloth: shows the renderer's last picture and turns drags into a view, or a light.

#include <array>
#include <string>

#include "gl/renderer.h"
#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// What stands behind the slider of the comparison.
struct ReferencePicture {
  unsigned texture = 0;  // of Compare::kSplit or kDifference, row 0 on top; 0: none yet
  int samples = 0;       // a pixel; 0: a coarse first picture
  float difference = 0;  // relative RMSE of the preview against it, over the cloth
  bool tracing = false;  // a better one is on its way
  std::string problem;
};

/// What there is to show.
struct PreviewPicture {
  unsigned texture = 0;  // 0: none yet
  FrameStats stats;
  float tolerance = 0, budget_ms = 0;  // it was drawn with; 0: not by time
  std::string problem;                 // why there is none, or what is wrong with the mesh
  bool busy = false;                   // the newest edit is still being worked on
  bool refining = false;               // a finer one of the same is on its way
  ReferencePicture reference;
};

/// Fills the rest of the current window. `pane` receives the size of the picture in pixels of the window.
void draw_preview(PanelContext& c, const PreviewPicture& picture, ImVec2& pane);

}  // namespace weftlight::views
