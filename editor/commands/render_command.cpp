// `weftlight render`: the lit, draped cloth as a picture, without a window.

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <utility>

#include "base/json.h"
#include "base/text.h"
#include "commands/file_options.h"
#include "commands/transparent.h"
#include "light/lod_table.h"
#include "render_data/method_weights.h"
#include "wif/wif.h"

namespace weftlight::commands {

using base::arg, base::fill, base::tr, base::write_file_atomically;
using design::Look, design::Method, design::Scene, design::method_name;
using gl::Frame, gl::FrameStats;
using render_data::kCoarsestTolerance;

namespace {

base::Result<void> write_stats(const std::string& path, const FrameStats& stats, float tolerance,
                               const PictureOptions& o) {
  const nlohmann::json json{{"method", method_name(stats.method)},
                            {"gpu_ms", stats.gpu_ms},
                            {"hair_ms", stats.flyaway_ms},
                            {"hairs", stats.flyaways},
                            {"shaded_pixels", stats.shaded_pixels},
                            {"tolerance", tolerance},
                            {"estimated_error", stats.estimated_error},
                            {"yarns_per_pixel", stats.yarns_per_pixel},
                            {"bytes", stats.texture_bytes},
                            {"width", o.width},
                            {"height", o.height}};
  return write_file_atomically(path, json.dump(2) + "\n");
}

/// "picture_001.png" from "picture.png" and 1.
std::string numbered(const std::string& path, int number) {
  const std::filesystem::path p(path);
  char digits[16];
  std::snprintf(digits, sizeof digits, "_%03d", number);
  return (p.parent_path() / (p.stem().string() + digits + p.extension().string())).string();
}

/// Progress of one picture of a meter, in passes over the cloth: an .exr is drawn once more in its own colours. Only a
/// software renderer, which takes seconds to minutes, reports it.
class DrawingProgress {
 public:
  DrawingProgress(ProgressMeter& meter, int index, std::string item, bool linear)
      : meter_(meter), index_(index), item_(std::move(item)), passes_(linear ? 2.0f : 1.0f) {}
  void operator()(float done) {
    constexpr double kDrawn = 0.98;  // the rest: to write the file
    if (index_ == 0 && !std::exchange(begun_, true)) meter_.begin();
    meter_.set(index_, kDrawn * static_cast<double>((passed_ + done) / passes_), item_);
    if (done >= 1) ++passed_;
  }

 private:
  ProgressMeter& meter_;
  int index_;
  std::string item_;
  float passes_, passed_ = 0;
  bool begun_ = false;
};

/// Draws one full turn of the view around its target, in even steps from its present azimuth.
int draw_turntable(PictureSetup& setup, const PictureOptions& o, Backdrop backdrop) {
  Frame frame = frame_over(setup, o, backdrop);
  Scene scene = setup.design.scene;
  const float from = scene.view_azimuth;
  ProgressMeter progress(setup.progress, o.turntable);
  for (int k = 0; k < o.turntable; ++k) {
    const std::string file = numbered(o.out, k + 1);
    progress.set(k, 0, file);
    DrawingProgress drawing(progress, k, file, writes_linear(o.out));
    if (setup.progress != ProgressForm::kNone) frame.progress = std::ref(drawing);
    scene.view_azimuth =
        std::remainder(from + 360.0f * static_cast<float>(k) / static_cast<float>(o.turntable), 360.0f);
    setup.renderer->draw(scene, setup.design.look, frame);
    if (const FrameStats stats = setup.renderer->measure(); !stats.cloth) {
      progress.clear();
      return fail(stats.cloth.error());
    }
    const auto saved = write_drawn(file, *setup.renderer, backdrop);
    if (!saved) {
      progress.clear();
      return fail(saved.error());
    }
    progress.set(k, 1, file);
  }
  return kDone;
}

/// Sets the tolerance that fits the budget. The first draw compiles the programs, the second one is timed.
void keep_within(double budget_ms, PictureSetup& setup, Frame frame) {
  Look& look = setup.design.look;
  setup.status.show(tr("measuring how long the cloth takes"));
  look.tolerance = kCoarsestTolerance;
  frame.timed = true;
  for (int k = 0; k < 2; ++k) setup.renderer->draw(setup.design.scene, look, frame);
  const float tolerance = setup.renderer->tolerance_within(static_cast<float>(budget_ms));
  if (tolerance > 0) look.tolerance = tolerance;
  setup.status.clear();
}

}  // namespace

int render_command(const PictureOptions& o) { return render_command(o, Backdrop::kShown); }

int render_command(const PictureOptions& o, Backdrop backdrop) {
  PictureSetup setup;
  if (o.turntable > 0 && !o.stats.empty()) return refuse(tr("--stats is for one picture; leave it or --turntable out"));
  for (int k = 1; k <= o.turntable; ++k)
    if (const std::string problem = replaces_input(numbered(o.out, k), {o.file, o.lights}); !problem.empty())
      return refuse(problem);
  if (o.turntable > 0)
    if (const auto place = base::check_writable(numbered(o.out, 1)); !place) return fail(place.error());
  if (const int code = setup.open(o); code != kDone) return code;
  if (o.budget_ms > 0) keep_within(o.budget_ms, setup, setup.frame(o));
  if (o.turntable > 0) return draw_turntable(setup, o, backdrop);
  const Method requested = setup.design.look.method;
  Frame frame = frame_over(setup, o, backdrop);
  frame.timed = !o.stats.empty();
  ProgressMeter progress(setup.progress, 1);
  const std::string drawn =
      fill(tr("drawing {width} x {height} pixels"), arg("width", o.width), arg("height", o.height));
  progress.set(0, 0, drawn);
  DrawingProgress drawing(progress, 0, drawn, writes_linear(o.out));
  if (setup.progress != ProgressForm::kNone) frame.progress = std::ref(drawing);
  setup.renderer->draw(setup.design.scene, setup.design.look, frame);
  const FrameStats stats = setup.renderer->measure();
  progress.clear();
  if (!stats.cloth) return fail(stats.cloth.error());
  if (requested != Method::kAuto && requested != stats.method) {
    print_problem(fill(tr("drawn with the method {method}, the closest one available"),
                       arg("method", std::string(method_name(stats.method)))));
  }
  base::Result<void> saved = write_drawn(o.out, *setup.renderer, backdrop);
  progress.clear();
  if (saved) progress.set(0, 1, o.out);
  if (saved && !o.stats.empty()) saved = write_stats(o.stats, stats, setup.design.look.tolerance, o);
  return finish(saved);
}

}  // namespace weftlight::commands
