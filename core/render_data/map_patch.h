#pragma once
// A flat patch of the cloth under parallel rays, pixel for pixel as trace_flat() of the ray tracer
// (core/reference/picture.h), so that a method can be compared with the reference. World here is cloth space: x along
// the weft, y along the warp, z out of the front, mm.

#include "draft/drawdown.h"
#include "light/formulas.h"
#include "render_data/ambient.h"

namespace weftlight::render_data {

using draft::Face;
using scene::Camera;

/// Pixel (x, y), row 0 on top, covers the parallelogram at corner_mm + x step_x_mm + y step_y_mm.
struct FlatPatch {
  int width = 0, height = 0;
  glm::vec2 corner_mm{0}, step_x_mm{1, 0}, step_y_mm{0, 1};
  glm::vec3 view{0, 0, 1};                  // unit, towards the eye, z > 0
  glm::vec3 light_towards{0, 0, 1};         // unit
  float light_sine = 0;                     // half angle of the light's disc, as a sine
  glm::vec3 light_irradiance{3.14159265f};  // at normal incidence
  float sky = 0;                            // radiance in direction sky_towards, falling to 0 in the opposite direction
  glm::vec3 sky_towards{0, 0, 1};           // as `view`
  int samples = 0;           // a pixel of method yarn: its largest lattice with no more; 0: by the tolerance
  int pass = 0;              // shifts the samples
  Face face = Face::kFront;  // the face that is up; x is along the weft on both
};

/// The patch with a margin, as two triangles that face the eye.
PreparedMesh patch_mesh(const FlatPatch& patch);
/// Camera along the parallel rays: the eye is a kilometre away.
Camera patch_camera(const FlatPatch& patch);

}  // namespace weftlight::render_data
