// `weftlight reference`: the picture of `render` with the cloth ray traced thread by thread. Ground, backdrop
// and the form under the cloth are those of the preview, so that only the cloth differs.

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "commands/commands.h"
#include "commands/picture_setup.h"
#include "light/formulas.h"
#include "preview/camera.h"
#include "preview/cloth_block.h"
#include "preview/light_rig.h"
#include "reference/picture.h"

namespace weftlight {
namespace {

/// Progress on a terminal only.
Progress terminal_progress() {
  if (!isatty(STDERR_FILENO)) return {};
  return [last = -1](float share) mutable {
    const int percent = static_cast<int>(share * 100);
    if (percent == last) return;
    last = percent;
    std::fprintf(stderr, "\r%3d %%%s", percent, percent == 100 ? "\n" : "");
  };
}

DrapePicture describe(const PictureOptions& o, const Scene& scene, const LightRig& rig, const Camera& camera) {
  DrapePicture picture;
  picture.width = o.width, picture.height = o.height;
  picture.spp = o.spp, picture.bounces = o.bounces;
  picture.eye = camera.eye;
  picture.clip_to_world = glm::inverse(camera.world_to_clip);
  picture.light_towards = direction_of(scene.light_azimuth, scene.light_elevation);
  picture.light_radius_rad = std::asin(kKeyRadius);
  picture.light_irradiance = rig.key * (kKeyIrradiance * scene.light_strength);
  picture.sky = [rig, strength = scene.sky_strength](glm::vec3 d) { return sky_radiance(rig, d) * strength; };
  picture.front = o.face == Face::kFront;
  return picture;
}

glm::vec3 texel(const Image& image, size_t pixel) {
  const float* t = &image.texels[pixel * static_cast<size_t>(image.channels)];
  return {t[0], t[1], t[2]};
}

float encode(float linear) { return srgb_from_linear({linear, linear, linear}).r; }
float decode(float srgb) { return linear_from_srgb({srgb, srgb, srgb}).r; }

/// The traced cloth over the preview's picture of all else.
void lay_over(Image& picture, const TracedImage& traced, float exposure, bool linear) {
  for (size_t i = 0; i < traced.pixels.size(); ++i) {
    const glm::vec4 p = traced.pixels[i];
    const glm::vec3 scene = glm::vec3(p) * exposure;
    const glm::vec3 behind = texel(picture, i);
    float* out = &picture.texels[i * static_cast<size_t>(picture.channels)];
    const glm::vec3 shown = p.a > 0 ? formulas::tone_map(scene / p.a) * p.a : glm::vec3(0);
    for (int k = 0; k < 3; ++k) {
      out[k] = linear ? scene[k] + behind[k] * (1 - p.a) : encode(shown[k] + decode(behind[k]) * (1 - p.a));
    }
    if (picture.channels == 4) out[3] = std::max(out[3], p.a);
  }
}

}  // namespace

int reference_command(const PictureOptions& o) {
  PictureSetup setup;
  if (const int code = setup.open(o); code != kDone) return code;
  std::string error;
  const Design& design = setup.design;
  const Cloth cloth = lay_out(design, drawdown(design.draft), Face::kFront, Period::kRepeat);
  const auto tubes = TubeScene::build(cloth, {}, error);
  if (!tubes) return fail(kBadInput, o.file + ": " + error);

  const ReadMesh mesh = load_drape(design.scene.mesh);
  if (!mesh.mesh) return fail(kBadInput, mesh.error);
  const auto drape = MeshScene::build(*mesh.mesh, error);
  if (!drape) return fail(kBadInput, error);
  const Mesh form = body_mesh(design.scene.mesh);
  const auto body = form.index.empty() ? nullptr : MeshScene::build(form, error);
  const LightRig rig = load_light_rig("studio", error);
  if (!error.empty()) return fail(kBadInput, error);

  Frame frame = setup.frame(o);
  frame.cloth = false;
  setup.renderer->draw(design.scene, design.look, frame);
  const bool linear = writes_linear(o.out);
  Image picture = setup.renderer->read_back(linear);
  const Camera camera = place_camera(design.scene, *mesh.mesh, bounds_of(*mesh.mesh), o.width, o.height, o.yarns_per_pixel,
                                     mean_spacing_mm(cloth));
  const TracedImage traced = trace_drape(*tubes, *drape, body.get(), describe(o, design.scene, rig, camera), terminal_progress());
  lay_over(picture, traced, std::exp2(design.look.exposure_ev), linear);
  error = write_picture(o.out, picture);
  return error.empty() ? kDone : fail(kNotWritten, error);
}

}  // namespace weftlight
