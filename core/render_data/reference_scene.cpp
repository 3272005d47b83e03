#include "render_data/reference_scene.h"

#include <algorithm>
#include <cmath>

#include "cloth/cloth.h"
#include "draft/drawdown.h"
#include "files/design_drape.h"
#include "light/formulas.h"
#include "render_data/ambient.h"
#include "render_data/cloth_block.h"
#include "render_data/face_cloth.h"

namespace weftlight::render_data {

using base::Result, base::failed;
using cloth::Cloth, cloth::Period, cloth::lay_out, cloth::linear_from_srgb, cloth::srgb_from_linear;
using draft::BitMatrix, draft::drawdown;
using drape::turn_diagonals;
using files::drape_key, files::load_design_drape;
using reference::Colours, reference::FibreOptions, reference::LightSample, reference::RandomStream,
    reference::SeenPatch, reference::seen_patch, reference::trace_drape;
using scene::Camera, scene::DistantLight, scene::Environment, scene::SceneLight, scene::bounds_of,
    scene::load_light_rig, scene::place_camera, scene::scene_light, scene::sky_radiance, scene::turned;

namespace {

glm::vec3 texel(const Image& image, size_t pixel) {
  const float* t = &image.texels[pixel * static_cast<size_t>(image.channels)];
  return {t[0], t[1], t[2]};
}

float encode(float linear) { return srgb_from_linear({linear, linear, linear}).r; }
float decode(float srgb) { return linear_from_srgb({srgb, srgb, srgb}).r; }

/// The traced pixel that covers pixel (x, y) of the picture.
glm::vec4 traced_at(const TracedImage& traced, const Image& picture, int x, int y) {
  const int64_t column = int64_t{x} * traced.width / picture.width, row = int64_t{y} * traced.height / picture.height;
  return traced.pixels[static_cast<size_t>(row * traced.width + column)];
}

}  // namespace

Result<void> ReferenceScene::update(const Design& design, const TubeOptions& options, TracedThreads traced) {
  // Files that may be unreadable come before the threads, which take long.
  if (Result<void> lights = update_lights(design.scene.lights); !lights) return lights;
  if (Result<void> drape = update_drape(design); !drape) return drape;
  return update_threads(design, options, traced);
}

Result<void> ReferenceScene::update_threads(const Design& design, const TubeOptions& options, TracedThreads traced) {
  const bool tubes = traced == TracedThreads::kTubes;
  if ((tubes_ || !tubes) && draft_ == design.draft && yarns_ == design.yarns && finish_ == design.finish &&
      same_shrinkage(plan_, design.plan))
    return {};
  tubes_ = nullptr;  // two at once could double the memory
  const BitMatrix cells = drawdown(design.draft);
  // Same period as the preview, so that each thread has the same fibres, unless the tubes would lose resolution.
  const int64_t kFineCrossings = is_uneven(design) ? 20'000 : 3000;
  const bool fine = !tubes || int64_t{design.draft.ends()} * design.draft.picks() <= kFineCrossings;
  const Cloth cloth = lay_out(design, cells, Face::kFront, fine ? choose_period(design, cells) : Period::kRepeat);
  if (tubes) {
    auto built = TubeScene::build(cloth, options);
    if (!built) return failed(built);
    tubes_ = std::move(*built);
  }
  mean_spacing_ = mean_spacing_mm(cloth);
  draft_ = design.draft;
  yarns_ = design.yarns, finish_ = design.finish, plan_ = design.plan;
  return {};
}

Result<void> ReferenceScene::update_drape(const Design& design) {
  const std::string key = drape_key(design);
  if (drape_ && mesh_name_ == key) return {};
  drape_ = nullptr;
  Result<Mesh> read = load_design_drape(design);
  if (!read) return failed(read);
  mesh_ = std::move(*read);
  turn_diagonals(mesh_);  // as in the preview
  bounds_ = bounds_of(mesh_);
  const Mesh form = form_under(design.scene.mesh, mesh_);
  body_ = nullptr;
  if (!form.index.empty()) body_ = MeshScene::build(form).value_or(nullptr);
  auto drape = MeshScene::build(mesh_);
  if (!drape) return failed(drape);
  drape_ = std::move(*drape);
  mesh_name_ = key;
  return {};
}

Result<void> ReferenceScene::update_lights(const std::string& name) {
  if (lights_name_ == name) return {};
  Result<LightRig> read = load_light_rig(name);
  if (!read) return failed(read);
  rig_ = std::move(*read);
  lights_name_ = name;
  return {};
}

DrapePicture ReferenceScene::picture_of(const ReferenceView& view) const {
  const Scene& scene = view.scene;
  const Camera camera =
      place_camera(scene, mesh_, bounds_, view.width, view.height, view.yarns_per_pixel, mean_spacing_);
  DrapePicture picture;
  picture.width = view.width, picture.height = view.height;
  picture.spp = view.spp, picture.bounces = view.bounces;
  // Without bounces one reflection stands for all of them.
  if (view.bounces > 0) picture.colours = Colours::kOfTheCloth;
  picture.first_sample = view.first_sample;
  picture.seed = view.seed;
  picture.layers = view.layers;
  picture.threads = view.threads;
  picture.stop = view.stop;
  picture.eye = camera.eye;
  picture.clip_to_world = glm::inverse(camera.world_to_clip);
  if (const Environment* around = rig_.environment.get()) {
    picture.light = [around, turn = scene.light_azimuth, strength = scene.light_strength](RandomStream& random) {
      const float u = random.next();
      const DistantLight light = around->sample(u, random.next());
      return LightSample{turned(light.towards, turn), light.irradiance * strength, light.radius};
    };
    picture.sky = [around, turn = scene.light_azimuth, strength = scene.sky_strength](glm::vec3 d) {
      return around->capped_radiance(turned(d, -turn)) * strength;
    };
  } else {
    const SceneLight light = scene_light(rig_, scene);
    picture.light_towards = light.lights[0].towards;
    picture.light_radius_rad = std::asin(light.lights[0].radius);
    picture.light_irradiance = light.lights[0].irradiance;
    picture.sky = [sky = light.sky](glm::vec3 d) { return sky_radiance(sky, d); };
  }
  picture.body_reflectance = form_reflectance();
  picture.front = view.front == Face::kFront;
  return picture;
}

Result<FibreFigures> ReferenceScene::prepare_fibres(const ReferenceView& view, int64_t max_bytes) {
  fibres_ = nullptr;
  const SeenPatch seen = seen_patch(*drape_, body_.get(), picture_of(view));
  FibreOptions options;
  options.low_mm = seen.low, options.high_mm = glm::max(seen.high, seen.low);
  options.max_bytes = max_bytes;
  // A nap is hair that stands off the threads; the threads themselves stay as they are woven.
  Design design;
  design.draft = draft_, design.yarns = yarns_, design.finish = finish_, design.plan = plan_;
  options.raised = finish_.raised;
  design.finish.raised = 0;
  const BitMatrix cells = drawdown(design.draft);
  auto built = FibreScene::build(lay_out(design, cells, Face::kFront, choose_period(design, cells)), options);
  if (!built) return failed(built);
  fibres_ = std::move(*built);
  return fibres_->figures();
}

TracedImage ReferenceScene::trace(const ReferenceView& view, const Progress& progress) const {
  if (view.fibres) return trace_drape(*fibres_, *drape_, body_.get(), picture_of(view), progress);
  return trace_drape(*tubes_, *drape_, body_.get(), picture_of(view), progress);
}

void lay_over(Image& picture, const TracedImage& traced, float exposure_ev, bool linear) {
  const float exposure = std::exp2(exposure_ev);
  size_t i = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x, ++i) {
      const glm::vec4 p = traced_at(traced, picture, x, y);
      if (p.a <= 0) continue;
      const glm::vec3 scene = glm::vec3(p) * exposure, background = texel(picture, i);
      const glm::vec3 shown = formulas::tone_map(scene / p.a) * p.a;
      float* out = &picture.texels[i * static_cast<size_t>(picture.channels)];
      for (int k = 0; k < 3; ++k) {
        out[k] = linear ? scene[k] + background[k] * (1 - p.a) : encode(shown[k] + decode(background[k]) * (1 - p.a));
      }
      if (picture.channels == 4) out[3] = p.a + out[3] * (1 - p.a);
    }
}

}  // namespace weftlight::render_data
