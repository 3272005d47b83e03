// Measurements on a drape (drapes.h).

#include <algorithm>
#include <cmath>

#include "chart/bench.h"
#include "chart/flip.h"
#include "platform/clock.h"
#include "scene/camera.h"
#include "scene/light_rig.h"

namespace weftlight::chart {

using design::Look, design::Method, design::Scene;
using drape::Mesh;
using gl::Frame, gl::FrameStats;
using reference::DrapePicture, reference::MeshScene, reference::trace_drape;
using render_data::PreparedMesh;
using scene::Camera, scene::LightRig, scene::SceneLight, scene::load_light_rig, scene::place_camera, scene::scene_light,
    scene::sky_radiance;

namespace {

Frame frame_of(double yarns_per_pixel, int width, int height) {
  Frame frame;
  frame.width = width, frame.height = height;
  frame.yarns_per_pixel = static_cast<float>(yarns_per_pixel);
  frame.ground = false, frame.transparent = true;
  return frame;
}

Look look_of(Method method) {
  Look look;
  look.method = method;
  return look;
}

base::Result<void> build_once(std::unique_ptr<MeshScene>& scene, const Mesh& mesh) {
  if (scene) return {};
  auto built = MeshScene::build(mesh);
  if (!built) return failed(built);
  scene = std::move(*built);
  return {};
}

/// The traced picture, with the camera and the lights of the renderer.
DrapePicture drape_picture(const PreparedMesh& mesh, const DrapeRow& cell, glm::ivec2 size, float spacing_mm) {
  const Scene scene = drape_scene(cell.light);
  const Camera camera =
      place_camera(scene, mesh.mesh, mesh.bounds, size.x, size.y, static_cast<float>(cell.yarns_per_pixel), spacing_mm);
  const SceneLight light = scene_light(load_light_rig(scene.lights).value_or(LightRig{}), scene);
  DrapePicture picture;
  picture.width = size.x, picture.height = size.y;
  picture.eye = camera.eye;
  picture.clip_to_world = glm::inverse(camera.world_to_clip);
  picture.light_towards = light.lights[0].towards;
  picture.light_radius_rad = std::asin(light.lights[0].radius);
  picture.light_irradiance = light.lights[0].irradiance;
  picture.sky = [sky = light.sky](glm::vec3 d) { return sky_radiance(sky, d); };
  return picture;
}

}  // namespace

base::Result<ChartBench::Loaded*> ChartBench::show_drape(size_t scene) {
  base::Result<Loaded*> shown = show(scene);
  if (!shown) return shown;
  Loaded& loaded = **shown;
  if (draped_scene_ != scene) renderer_->set_mesh(loaded.mesh);
  draped_scene_ = scene;
  if (auto built = build_once(loaded.drape, loaded.mesh.mesh); !built) return failed(built);
  if (!loaded.mesh.body.index.empty())
    if (auto built = build_once(loaded.body, loaded.mesh.body); !built) return failed(built);
  if (const auto traced = tubes(loaded); !traced) return failed(traced);
  return shown;
}

const Truth& ChartBench::draped_truth(size_t scene, const DrapeRow& cell) {
  Loaded& loaded = *loaded_[scene];
  Truth& truth = loaded.draped_truths[{cell.light, cell.yarns_per_pixel}];
  if (!truth.half.empty()) return truth;
  DrapePicture picture =
      drape_picture(loaded.mesh, cell, {effort_.drape_width, effort_.drape_height}, loaded.packed.mean_spacing_mm);
  picture.spp = std::max(4, effort_.drape_rays / (picture.width * picture.height));
  picture.bounces = 2, picture.colours = reference::Colours::kOfTheCloth;
  for (Pixels* half : {&truth.half, &truth.other_half}) {
    *half = colours(trace_drape(*loaded.tubes, *loaded.drape, loaded.body.get(), picture, {}));
    picture.first_sample = 5000;  // far from the samples of the first half, so that both are independent
  }
  return truth;
}

/// Nanoseconds of a picture (processor time for a software renderer): the minimum of two, since the first may compile a
/// program.
double ChartBench::picture_ns(const DrapeRow& cell, const Frame& frame, FrameStats& stats) {
  const Scene scene = drape_scene(cell.light);
  std::vector<uint32_t> pixels;
  double least = 0;
  for (int k = 0; k < 2; ++k) {
    const double before = platform::processor_ns();
    renderer_->draw(scene, look_of(cell.method), frame);
    stats = renderer_->measure();
    renderer_->read_pixels(pixels);  // waits for the picture
    const double ns = renderer_->is_software() ? (platform::processor_ns() - before) / cores() : stats.gpu_ms * 1e6;
    least = k == 0 ? ns : std::min(least, ns);
  }
  return least;
}

/// Nanoseconds per shaded pixel of cloth: the extra time over a picture without the cloth, which is the same for all
/// methods.
double ChartBench::draped_ns(size_t scene, const DrapeRow& cell) {
  const int drawn = cell.method == Method::kYarn ? effort_.drape_yarn_timing_size : effort_.drape_timing_size;
  const int size = renderer_->is_software() ? drawn : timing_size(cell.method);
  Frame frame = frame_of(cell.yarns_per_pixel, size, size);
  frame.timed = true;
  FrameStats stats;
  const double with = picture_ns(cell, frame, stats);
  if (!renderer_->is_software()) return with / std::max(stats.shaded_pixels, 1.0);
  FrameStats unused;
  frame.cloth = false;
  const auto [at, fresh] = loaded_[scene]->bare_ns.try_emplace({cell.light, cell.yarns_per_pixel, size}, 0.0);
  if (fresh) at->second = picture_ns(cell, frame, unused);
  return std::max(with - at->second, 0.0) / std::max(stats.shaded_pixels, 1.0);
}

base::Result<DrapeRow> ChartBench::draped(const DrapeRow& cell) {
  const size_t scene = scene_named(cell.scene);
  if (const auto shown = show_drape(scene); !shown) return failed(shown);
  const Truth& truth = draped_truth(scene, cell);
  const Frame frame = frame_of(cell.yarns_per_pixel, effort_.drape_width, effort_.drape_height);
  renderer_->draw(drape_scene(cell.light), look_of(cell.method), frame);
  const Pixels drawn = colours(renderer_->read_back(true));
  DrapeRow row = cell;
  row.model_error = relative_rmse(drawn, truth.half, truth.other_half);
  row.flip = flip_error(drawn, mean_of(truth), frame.width, frame.height);
  row.energy_ratio = 0.5 * (mean_ratio(drawn, truth.half) + mean_ratio(drawn, truth.other_half));
  row.truth_noise = noise_of(truth.half, truth.other_half);
  row.ns_per_pixel = draped_ns(scene, cell);
  return row;
}

}  // namespace weftlight::chart
