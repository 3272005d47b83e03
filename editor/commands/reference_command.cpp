// `weftlight reference`: the picture of `render`, with the threads of the cloth ray traced. The ground, the backdrop
// and the body under the cloth are drawn by the renderer, so that only the cloth differs.

#include "base/text.h"
#include "commands/commands.h"
#include "commands/picture_setup.h"
#include "render_data/reference_scene.h"

namespace weftlight::commands {

using base::arg, base::fill, base::message, base::tr;
using design::Design, design::Scene;
using files::Image;
using gl::Frame, gl::FrameStats;
using reference::Progress, reference::TracedImage;
using render_data::ReferenceScene, render_data::ReferenceView, render_data::lay_over;

namespace {

Progress progress_on(StatusLine& status) {
  return [&status, last = -1](float done) mutable {
    const int percent = static_cast<int>(done * 100);
    if (percent == last) return;
    last = percent;
    status.show(fill(tr("tracing: {percent} %"), arg("percent", percent)));
  };
}

ReferenceView view_of(const PictureOptions& o, const Scene& scene) {
  ReferenceView view;
  view.scene = scene;
  view.width = o.width, view.height = o.height;
  view.yarns_per_pixel = o.yarns_per_pixel;
  view.front = o.face;
  view.spp = o.spp, view.bounces = o.bounces;
  return view;
}

}  // namespace

int reference_command(const PictureOptions& o) {
  PictureSetup setup;
  if (const int code = setup.open(o); code != kDone) return code;
  const Design& design = setup.design;
  ReferenceScene scene;
  if (const auto updated = scene.update(design); !updated)
    return fail({updated.error().kind, message(updated.error()), o.file});

  Frame frame = setup.frame(o);
  frame.cloth = false;
  const FrameStats drawn = setup.renderer->draw(design.scene, design.look, frame);
  const bool linear = writes_linear(o.out);
  Image picture = setup.renderer->read_back(linear);
  const TracedImage traced = scene.trace(view_of(o, design.scene), progress_on(setup.status));
  setup.status.clear();
  lay_over(picture, traced, linear ? design.look.exposure_ev : drawn.exposure_ev, linear);
  return finish(write_picture(o.out, picture));
}

}  // namespace weftlight::commands
