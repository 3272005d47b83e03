// `weftlight reference`: the picture of `render`, with the threads of the cloth ray traced. The ground, the backdrop
// and the body under the cloth are drawn by the renderer, so that only the cloth differs.

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "commands/commands.h"
#include "commands/open_design.h"
#include "commands/transparent.h"
#include "render_data/picture_layers.h"
#include "render_data/reference_scene.h"

namespace weftlight::commands {

using base::arg, base::fill, base::message, base::tr;
using design::Design, design::Scene;
using files::Image;
using gl::Frame, gl::FrameStats;
using reference::Progress, reference::TracedImage;
using render_data::ReferenceScene, render_data::ReferenceView, render_data::TracedThreads, render_data::lay_over,
    render_data::layer_channels, render_data::with_layers;

namespace {

Progress progress_on(ProgressMeter& meter, const std::string& out) {
  return [&meter, out](float done) { meter.set(0, std::min(static_cast<double>(done), 0.999), out); };
}

ReferenceView view_of(const PictureOptions& o, const Scene& scene) {
  ReferenceView view;
  view.scene = scene;
  view.width = o.width, view.height = o.height;
  view.yarns_per_pixel = o.yarns_per_pixel;
  view.front = o.face;
  view.spp = o.spp, view.bounces = o.bounces;
  view.fibres = o.fibres;
  view.layers = o.layers, view.seed = o.seed;
  return view;
}

/// kDone, or the code of a line on stderr: layers are asked for that no .exr of ours holds.
int check_layers(const PictureOptions& o) {
  constexpr int64_t kMostPixels = 25'000'000;  // of an image's 2^29 values (core/files)
  if (!o.layers) return kDone;
  if (!writes_linear(o.out)) return refuse(tr("--layers: give an .exr as the output"));
  if (int64_t{o.width} * o.height <= kMostPixels) return kDone;
  return refuse(fill(tr("--layers: give a --size of at most {count} million pixels, such as 5000x5000"),
                     arg("count", kMostPixels / 1'000'000)));
}

int in_mb(int64_t bytes) { return static_cast<int>((bytes + (1 << 20) - 1) >> 20); }

/// Makes the fibres and prints what they are and the memory that they take, unless it is to be quiet.
base::Result<void> make_fibres(ReferenceScene& scene, const ReferenceView& view, StatusLine& status, bool quiet) {
  status.show(tr("making the fibres"));
  const auto made = scene.prepare_fibres(view);
  status.clear();
  if (!made) return base::failed(made);
  if (quiet) return {};
  print_row(tr("Cloth of fibres"),
            fill(tr("{width} x {height} mm, {threads} threads"), arg("width", std::round(10 * made->size_mm.x) / 10),
                 arg("height", std::round(10 * made->size_mm.y) / 10), arg("threads", made->threads)));
  print_row(tr("Fibres"), fill(tr("{fibres} across the picture, {strays} hairs and loops, {curves} curves"),
                               arg("fibres", made->fibres), arg("strays", made->strays), arg("curves", made->curves)));
  print_row(tr("Memory"), fill(tr("{used} MB, estimated {estimate} MB"), arg("used", in_mb(scene.fibre_bytes())),
                               arg("estimate", in_mb(made->bytes))));
  return {};
}

}  // namespace

int reference_command(const PictureOptions& o) { return reference_command(o, Backdrop::kShown); }

int reference_command(const PictureOptions& o, Backdrop backdrop) {
  if (const int code = check_layers(o); code != kDone) return code;
  PictureSetup setup;
  if (const int code = setup.read(o); code != kDone) return code;
  const Design& design = setup.design;
  ReferenceScene scene;
  const TracedThreads traced_as = o.fibres ? TracedThreads::kFibres : TracedThreads::kTubes;
  if (const auto updated = scene.update(design, {}, traced_as); !updated)
    return fail({updated.error().kind, message(updated.error()), o.file});
  const ReferenceView view = view_of(o, design.scene);
  if (o.fibres) {
    if (const auto made = make_fibres(scene, view, setup.status, o.quiet); !made)
      return fail({made.error().kind, message(made.error()), o.file});
  }

  // An automatic exposure is that of the cloth, which .exr does without.
  const bool linear = writes_linear(o.out);
  if (const int code = setup.upload(!linear && design.look.automatic_exposure); code != kDone) return code;
  Frame frame = frame_over(setup, o, backdrop);
  frame.cloth = false;
  const FrameStats drawn = setup.renderer->draw(design.scene, design.look, frame);
  if (!drawn.cloth) return fail(drawn.cloth.error());
  Image picture = setup.renderer->read_back(linear);
  if (const auto around = setup.renderer->measure().cloth; !around) return fail(around.error());
  ProgressMeter meter(setup.progress, 1);
  const TracedImage traced = scene.trace(view, progress_on(meter, o.out));
  meter.clear();
  lay_over(picture, traced, linear ? design.look.exposure_ev : drawn.exposure_ev, linear);
  const base::Result<void> saved =
      o.layers ? files::write_image(o.out, with_layers(picture, traced, design.look.exposure_ev),
                                    files::PixelType::kFloat, layer_channels())
               : write_picture(o.out, picture, backdrop);
  if (saved) meter.set(0, 1, o.out);
  return finish(saved);
}

}  // namespace weftlight::commands
