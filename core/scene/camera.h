#pragma once
// The camera. World: millimetres, +y up, the front of the mesh is +z.

#include <glm/glm.hpp>

#include "design/design.h"
#include "drape/mesh.h"

namespace weftlight::scene {

using design::Scene;
using drape::Mesh;

struct Bounds {
  glm::vec3 low{0}, high{0};
  // Of a form: how far it reaches from the upright axis through the centre. 0: a flat swatch.
  float reach = 0;
  glm::vec3 centre() const { return 0.5f * (low + high); }
  float radius() const { return 0.5f * glm::length(high - low); }
};
Bounds bounds_of(const Mesh& mesh);

/// Unit vector towards an azimuth (0 is +z, positive to the right) and elevation, in degrees.
glm::vec3 direction_of(float azimuth_deg, float elevation_deg);

struct Camera {
  glm::vec3 eye{0};
  glm::mat4 world_to_clip{1};
  float pixel_mm = 1;  // size of a pixel at the surface in the centre of the picture
};

/// Frames the mesh at view_distance 1: nothing of it is cut off, and a form keeps its size while the view turns round
/// it. For smaller distances the field of view narrows, so that the eye never enters the folds. `yarns_per_pixel` > 0
/// sets the footprint at the centre instead.
Camera place_camera(const Scene& scene, const Mesh& mesh, const Bounds& bounds, int width, int height,
                    float yarns_per_pixel, float mean_spacing_mm);

/// The view_distance, at most 1, at which a straight view shows `height_mm` of the bounds.
float distance_of_height(const Bounds& bounds, float aspect, float height_mm);

}  // namespace weftlight::scene
