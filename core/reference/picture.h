#pragma once
// Reference pictures: the draped cloth, and flat patches for the chart, thread by thread.

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <stop_token>
#include <vector>

#include "reference/mesh_scene.h"
#include "reference/names.h"
#include "reference/trace.h"

namespace weftlight::reference {

/// Linear RGB and coverage of each pixel, row 0 on top. rgb is premultiplied by alpha.
struct TracedImage {
  int width = 0, height = 0;
  std::vector<glm::vec4> pixels;
};

/// Called with the share done, 0..1, from one thread at a time.
using Progress = std::function<void(float)>;

/// One light of many: over the chance that it was chosen, so that the mean of many is all their light.
struct LightSample {
  glm::vec3 towards{0, 0, 1};  // world
  glm::vec3 irradiance{0};     // at right angles
  float radius_rad = 0;
};

struct DrapePicture {
  int width = 0, height = 0, spp = 64, bounces = 0;
  glm::vec3 eye{0};
  glm::mat4 clip_to_world{1};
  glm::vec3 light_towards{0, 0, 1};  // world
  float light_radius_rad = 0.005f;
  glm::vec3 light_irradiance{3.14159265f};
  std::function<LightSample(RandomStream&)> light;  // for each sample another; empty: the one above
  std::function<glm::vec3(glm::vec3)> sky;          // radiance by world direction; empty: black
  bool front = true;                                // the mesh's front shows the cloth's front
  int first_sample = 0;  // of each pixel: pictures that go on where others ended may be averaged
  int threads = 0;       // 0: all cores
  std::stop_token stop;  // when asked to stop, the rows not yet begun stay empty
};
/// The mesh gives position and frame; in each point's frame the ray goes through the endless flat cloth.
/// `body`: what stops light beside the cloth, may be null.
TracedImage trace_drape(const TubeScene& tubes, const MeshScene& cloth, const MeshScene* body,
                        const DrapePicture& picture, const Progress& progress);

/// A flat patch under parallel rays. Pixel (x, y) covers the parallelogram with corner
/// corner_mm + x step_x + y step_y on the plane z = 0, as a camera at `view` sees it.
struct FlatPicture {
  int width = 0, height = 0, spp = 64, bounces = 0;
  glm::vec2 corner_mm{0}, step_x_mm{1, 0}, step_y_mm{0, 1};
  glm::vec3 view{0, 0, 1};  // unit, towards the eye, cloth space
  Surroundings around;
  uint64_t seed = 0;  // other seeds give independent samples
};
TracedImage trace_flat(const TubeScene& tubes, const FlatPicture& picture, const Progress& progress);

}  // namespace weftlight::reference
