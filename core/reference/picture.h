#pragma once
// Ray-traced reference pictures: the draped cloth, and flat patches for the chart, thread by thread.

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <stop_token>
#include <vector>

#include "reference/fibre_scene.h"
#include "reference/mesh_scene.h"
#include "reference/trace.h"

namespace weftlight::reference {

/// What a pixel shows of the threads beside their light: means over the samples that meet them; all 0 where none does.
struct PixelLayers {
  float depth_mm = 0;   // along the axis of the camera
  glm::vec3 normal{0};  // unit, in the world; of the threads with their fibres
  glm::vec2 uv_mm{0};   // on the cloth; of one sample, since a mean over a seam would be neither side's
  glm::vec3 albedo{0};  // colour of the fibres, linear
  glm::vec3 direct{0};  // of the radiance, premultiplied as that is: what comes without another thread between
  System system = System::kWarp;
  int thread = -1;  // that most samples meet
};

/// Linear RGB and coverage of each pixel, row 0 on top. rgb is premultiplied by alpha.
struct TracedImage {
  int width = 0, height = 0;
  std::vector<glm::vec4> pixels;
  std::vector<PixelLayers> layers{};  // empty unless they were asked for
};

/// Called with the fraction done, 0..1, from one thread at a time.
using Progress = std::function<void(float)>;

/// One light sample: its irradiance is divided by the probability of choosing it, so that the mean over many is all of
/// the light.
struct LightSample {
  glm::vec3 towards{0, 0, 1};  // world
  glm::vec3 irradiance{0};     // at normal incidence
  float radius_rad = 0;
};

struct DrapePicture {
  int width = 0, height = 0, spp = 64, bounces = 0;
  Colours colours = Colours::kOfOneReflection;
  glm::vec3 eye{0};
  glm::mat4 clip_to_world{1};
  glm::vec3 light_towards{0, 0, 1};  // world
  float light_radius_rad = 0.005f;
  glm::vec3 light_irradiance{3.14159265f};
  std::function<LightSample(RandomStream&)> light;  // a light for each sample; empty: the one above
  std::function<glm::vec3(glm::vec3)> sky;          // radiance by world direction; empty: black
  glm::vec3 body_reflectance{0};                    // of the sky's light; the key light is not sent on
  bool front = true;                                // the front of the mesh shows the front of the cloth
  int first_sample = 0;  // index of the first sample of each pixel, so that passes can be averaged
  uint64_t seed = 0;     // different seeds give independent samples
  bool layers = false;   // of tubes alone
  int threads = 0;       // 0: all cores
  std::stop_token stop;  // when stopped, the remaining rows stay empty
};
/// The mesh gives position and frame; in the frame of each point the ray continues through the infinite flat cloth.
/// `body`: what occludes light beside the cloth; may be null.
TracedImage trace_drape(const TubeScene& tubes, const MeshScene& cloth, const MeshScene* body,
                        const DrapePicture& picture, const Progress& progress);

/// The same with the cloth's fibres, without a limit on bounces; the lamp's light is spread as lamp_spread() says
/// (fibre_trace.h).
TracedImage trace_drape(const FibreScene& fibres, const MeshScene& cloth, const MeshScene* body,
                        const DrapePicture& picture, const Progress& progress);

/// The part of the cloth, in mm of its (u, v), that a picture shows in front of everything else; low above high if it
/// shows none.
struct SeenPatch {
  glm::vec2 low{0}, high{-1};
};
SeenPatch seen_patch(const MeshScene& cloth, const MeshScene* body, const DrapePicture& picture);

/// A flat patch under parallel rays. Pixel (x, y) covers the parallelogram at corner_mm + x step_x + y step_y on the
/// plane z = 0, as a camera at `view` sees it.
struct FlatPicture {
  int width = 0, height = 0, spp = 64, bounces = 0;
  Colours colours = Colours::kOfOneReflection;
  glm::vec2 corner_mm{0}, step_x_mm{1, 0}, step_y_mm{0, 1};
  glm::vec3 view{0, 0, 1};  // unit, towards the eye, cloth space
  Surroundings around;
  uint64_t seed = 0;  // different seeds give independent samples
  // Single fibres on the tubes, as a preview with pixels of this size resolves them; otherwise they stay in the lobes,
  // as for a mean over the cloth.
  bool fibre_detail = false;
};
TracedImage trace_flat(const TubeScene& tubes, const FlatPicture& picture, const Progress& progress);
TracedImage trace_flat(const FibreScene& fibres, const FlatPicture& picture, const Progress& progress);

}  // namespace weftlight::reference
