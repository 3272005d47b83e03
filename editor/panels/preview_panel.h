#pragma once
// The lit cloth: shows the renderer's last picture and turns drags into a view, or a light.

#include <array>
#include <string>

#include "gl/renderer.h"
#include "panels/names.h"
#include "panels/panel.h"

namespace weftlight::panels {

/// What stands behind the slider of the comparison.
struct ReferencePicture {
  unsigned texture = 0;  // of Compare::kSplit or kDifference, row 0 on top; 0: none yet
  int samples = 0;       // a pixel; 0: a coarse first picture
  float difference = 0;  // relative RMSE of the preview against it, over the cloth
  bool tracing = false;  // a better one is on its way
  std::string problem;
};
inline constexpr float kDifferenceScale = 4;  // the picture of the difference is this much brighter

/// What there is to show.
struct PreviewPicture {
  unsigned texture = 0;  // 0: none yet
  FrameStats stats;
  std::string problem;  // why there is none, or what is wrong with the mesh
  bool busy = false;    // the newest edit is still being worked on
  ReferencePicture reference;
};

/// Scene::view_* and pan_* as the weaver turned them, not yet part of the design.
struct Orbit {
  float azimuth = 0, elevation = 0, distance = 1, pan_x = 0, pan_y = 0;
  bool operator==(const Orbit&) const = default;
};
Orbit orbit_of(const Scene& scene);
Scene with_orbit(Scene scene, const Orbit& camera);

/// Drag by (dx, dy) and zoom about (x, y), all in pane widths and heights from the middle, y up.
Orbit orbited(Orbit camera, float dx_px, float dy_px, float degrees_a_px);
Orbit zoomed(Orbit camera, float steps, float x, float y);

/// Fills the rest of the current window; changes `camera` as the weaver drags. An edit moves the light.
/// `pane` receives the size of the picture in pixels of the window.
MaybeEdit draw_preview(PanelContext& c, const PreviewPicture& picture, Orbit& camera, ImVec2& pane);

}  // namespace weftlight::panels
