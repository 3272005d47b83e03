// `weftlight reference`: the picture of `render` with the cloth ray traced thread by thread. Ground, backdrop
// and the form under the cloth are those of the preview, so that only the cloth differs.

#include "commands/commands.h"
#include "commands/picture_setup.h"
#include "render_data/reference_scene.h"

namespace weftlight::commands {
namespace {

Progress progress_on(StatusLine& status) {
  return [&status, last = -1](float share) mutable {
    const int percent = static_cast<int>(share * 100);
    if (percent == last) return;
    last = percent;
    status.say("tracing: " + std::to_string(percent) + " %");
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
  std::string error = scene.update(design);
  if (!error.empty()) return fail(kBadInput, o.file + ": " + error);

  Frame frame = setup.frame(o);
  frame.cloth = false;
  const FrameStats drawn = setup.renderer->draw(design.scene, design.look, frame);
  const bool linear = writes_linear(o.out);
  Image picture = setup.renderer->read_back(linear);
  const TracedImage traced = scene.trace(view_of(o, design.scene), progress_on(setup.status));
  setup.status.clear();
  lay_over(picture, traced, linear ? design.look.exposure_ev : drawn.exposure_ev, linear);
  error = write_picture(o.out, picture);
  return error.empty() ? kDone : not_written(error);
}

}  // namespace weftlight::commands
