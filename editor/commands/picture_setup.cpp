#include "commands/picture_setup.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <mutex>

#include "base/file_names.h"
#include "base/text.h"
#include "commands/open_design.h"
#include "design/lights.h"
#include "files/design_drape.h"
#include "files/files.h"
#include "gl/open_headless.h"
#include "gl/pipeline.h"
#include "light/lod_table.h"
#include "scene/named_views.h"

namespace weftlight::commands {

using base::arg, base::extension_of, base::fill, base::message, base::tr;
using design::Method, design::NamedView, design::Scene, design::is_environment, design::lighting_preset, design::lit_by,
    design::lit_by_environment, design::method_from_name;
using draft::Draft;
using files::PixelType, files::can_drape, files::drape_cloth, files::is_draped, files::write_image;
using gl::upload_once;
using render_data::StageWatch;
using scene::drawn_scene, scene::view_named, scene::view_names;

namespace {

void apply_options(Design& design, const PictureOptions& o) {
  Scene& scene = design.scene;
  if (!o.mesh.empty()) scene = on_mesh(scene, o);
  if (o.simulated_drape) scene.simulated_drape = true;
  if (is_environment(o.lights)) scene = lit_by_environment(scene, o.lights);
  else if (!o.lights.empty()) scene = lit_by(scene, lighting_preset(o.lights));
  if (o.surroundings) scene.surroundings = true;
  if (!std::isnan(o.view_azimuth)) scene.view_azimuth = o.view_azimuth, scene.view_elevation = o.view_elevation;
  if (!std::isnan(o.light_azimuth)) scene.light_azimuth = o.light_azimuth, scene.light_elevation = o.light_elevation;
  if (!std::isnan(o.exposure_ev)) {
    design.look.exposure_ev = o.exposure_ev;
    design.look.automatic_exposure = o.automatic_exposure;
  }
  if (o.tolerance > 0) design.look.tolerance = o.tolerance;
  if (!o.method.empty()) design.look.method = method_from_name(o.method).value_or(Method::kAuto);
}

/// Simulates this fabric's drape if the scene asks for it and it is not cached yet.
void drape(const Design& design, StatusLine& status) {
  if (!design.scene.simulated_drape || !can_drape(design) || is_draped(design)) return;
  const base::Result<void> done = drape_cloth(design, [&status](double share) {
    status.show(fill(tr("simulating the drape: {percent}%"), arg("percent", static_cast<int>(100 * share))));
    return true;
  });
  status.clear();
  if (!done)
    print_problem(
        fill(tr("warning: {problem}; the generic drape is drawn instead"), arg("problem", message(done.error()))));
}

std::string no_view_text(const Design& design, const std::string& name) {
  std::string names;
  for (const std::string& one : view_names(design)) names.append(names.empty() ? "" : ", ").append(one);
  return fill(tr("no view is called '{name}'; the views are {names}"), arg("name", name), arg("names", names));
}

}  // namespace

Scene on_mesh(Scene scene, const PictureOptions& o) {
  const bool another = scene.mesh != o.mesh, asked = !o.view_name.empty() || o.yarns_per_pixel > 0;
  scene.mesh = o.mesh;
  if (!another || asked) return scene;
  const Scene whole;
  scene.view_azimuth = whole.view_azimuth, scene.view_elevation = whole.view_elevation;
  scene.view_distance = whole.view_distance, scene.pan_x = whole.pan_x, scene.pan_y = whole.pan_y;
  return scene;
}

namespace {

/// Shows which step a picture's maps are at. Those of the scene run beside them, and are fewer and quick.
StageWatch steps_shown(const std::string& what, StatusLine& status) {
  struct Shown {
    std::mutex mutex;
    size_t most = 0;
  };
  const auto shown = std::make_shared<Shown>();
  return {{}, [shown, &status, what](const char*, size_t done, size_t of) {
            const std::lock_guard lock(shown->mutex);
            if (of < shown->most) return;
            shown->most = of;
            status.show(
                fill(tr("{what}: step {step} of {count}"), arg("what", what), arg("step", done + 1), arg("count", of)));
          }};
}

}  // namespace

int PictureSetup::open(const PictureOptions& o) {
  const int code = read(o);
  return code == kDone ? upload() : code;
}

int PictureSetup::read(const PictureOptions& o) {
  progress = o.progress_json ? ProgressForm::kJson : o.quiet ? ProgressForm::kNone : ProgressForm::kTerminal;
  if (progress != ProgressForm::kTerminal) status.silence();
  if (const auto place = o.turntable > 0 ? base::Result<void>() : base::check_writable(o.out); !place)
    return fail(place.error());
  if (const auto place = o.stats.empty() ? base::Result<void>() : base::check_writable(o.stats); !place)
    return fail(place.error());
  draft_ = o.file;
  status.show(fill(tr("reading {file}"), arg("file", o.file)));
  OpenedDesign opened = open_design(o.file);
  status.clear();
  if (!opened.ok) return kBadInput;
  design = std::move(opened.design);
  if (!o.view_name.empty()) {
    const std::optional<NamedView> view =
        view_named(design, o.view_name, static_cast<float>(o.width), static_cast<float>(o.height));
    if (!view)
      return refuse(
          fill(tr("{file}: {problem}"), arg("file", o.file), arg("problem", no_view_text(design, o.view_name))));
    design.scene = drawn_scene(*view);
  }
  apply_options(design, o);
  if (o.surroundings && !is_environment(design.scene.lights))
    return refuse(tr("--surroundings shows an environment map, and there is none; give --environment with it"));
  drape(design, status);
  return open_graphics();
}

int PictureSetup::upload(bool cloth) {
  if (const auto& read = renderer->lod_table_read(); !read) print_problem(problem_of(read));
  const Draft& d = design.draft;
  const std::string weaving =
      fill(tr("weaving {ends} ends by {picks} picks"), arg("ends", d.ends()), arg("picks", d.picks()));
  status.show(weaving);
  base::Result<void> shown =
      upload_once(std::make_shared<const Design>(design), *renderer, steps_shown(weaving, status), cloth);
  status.clear();
  for (const std::string& remark : renderer->light_remarks()) print_problem(remark);
  if (!shown && shown.error().kind == base::ErrorKind::kInput && shown.error().file.empty())
    shown.error().file = draft_;
  return finish(shown);
}

int PictureSetup::open_graphics() {
  const auto none = [](const base::Error& error) {
    return fail({base::ErrorKind::kGraphics, fill(tr("no graphics: {problem}"), arg("problem", message(error)))});
  };
  auto opened = gl::open_headless();
  if (!opened) return none(opened.error());
  context = std::move(*opened);
  auto made = Renderer::create();
  if (!made) return none(made.error());
  renderer = std::move(*made);
  return kDone;
}

Frame PictureSetup::frame(const PictureOptions& o) const {
  Frame frame;
  frame.width = o.width, frame.height = o.height;
  frame.yarns_per_pixel = o.yarns_per_pixel;
  frame.front = o.face;
  if (o.samples > 0) frame.samples = frame.all_samples = o.samples, frame.exact_samples = true;
  return frame;
}

bool writes_linear(const std::string& path) { return extension_of(path) == ".exr"; }

base::Result<void> write_picture(const std::string& path, const Image& image) {
  if (writes_linear(path)) return write_image(path, image, PixelType::kHalf);
  // The picture is opaque, and a PNG without alpha is smaller and read by every program.
  Image rgb{image.width, image.height, 3, {}};
  rgb.texels.reserve(image.texels.size() / 4 * 3);
  for (size_t i = 0; i < image.texels.size(); i += 4) {
    rgb.texels.insert(rgb.texels.end(), image.texels.begin() + static_cast<long>(i),
                      image.texels.begin() + static_cast<long>(i + 3));
  }
  return write_image(path, rgb, PixelType::kU8);
}

}  // namespace weftlight::commands
