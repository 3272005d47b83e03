// `weftlight render`: the lit, draped cloth as a picture, without a window.

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "commands/picture_setup.h"
#include "light/lod_table.h"
#include "render_data/method_weights.h"
#include "wif/wif.h"

namespace weftlight::commands {
namespace {

std::string write_stats(const std::string& path, const FrameStats& stats, float tolerance, const PictureOptions& o) {
  const nlohmann::json json{{"method", method_name(stats.method)},
                            {"gpu_ms", stats.gpu_ms},
                            {"flyaway_ms", stats.flyaway_ms},
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

/// PICTURE_001.png of PICTURE.png.
std::string numbered(const std::string& path, int number) {
  const std::filesystem::path p(path);
  char digits[16];
  std::snprintf(digits, sizeof digits, "_%03d", number);
  return (p.parent_path() / (p.stem().string() + digits + p.extension().string())).string();
}

/// One turn of the view around what is seen, in even steps from where it stands.
int draw_turntable(PictureSetup& setup, const PictureOptions& o) {
  const Frame frame = setup.frame(o);
  Scene scene = setup.design.scene;
  const float from = scene.view_azimuth;
  for (int k = 0; k < o.turntable; ++k) {
    setup.status.say("drawing picture " + std::to_string(k + 1) + " of " + std::to_string(o.turntable));
    scene.view_azimuth =
        std::remainder(from + 360.0f * static_cast<float>(k) / static_cast<float>(o.turntable), 360.0f);
    setup.renderer->draw(scene, setup.design.look, frame);
    if (const FrameStats stats = setup.renderer->measure(); !stats.problem.empty()) {
      setup.status.clear();
      return fail(kNoGraphics, stats.problem);
    }
    const std::string error = write_picture(numbered(o.out, k + 1), setup.renderer->read_back(writes_linear(o.out)));
    if (!error.empty()) {
      setup.status.clear();
      return not_written(error);
    }
  }
  setup.status.clear();
  return kDone;
}

/// Draws once to have the programs compiled, and once to see what this machine takes.
void keep_within(double budget_ms, PictureSetup& setup, Frame frame) {
  Look& look = setup.design.look;
  look.tolerance = kCoarsestTolerance;
  frame.timed = true;
  for (int k = 0; k < 2; ++k) setup.renderer->draw(setup.design.scene, look, frame);
  const float held = setup.renderer->tolerance_within(static_cast<float>(budget_ms));
  if (held > 0) look.tolerance = held;
}

}  // namespace

int render_command(const PictureOptions& o) {
  PictureSetup setup;
  if (o.turntable > 0 && !o.stats.empty())
    return fail(kUsage, "--stats is of one picture: leave it or --turntable out");
  if (const int code = setup.open(o); code != kDone) return code;
  if (o.budget_ms > 0) keep_within(o.budget_ms, setup, setup.frame(o));
  if (o.turntable > 0) return draw_turntable(setup, o);
  const Method asked = setup.design.look.method;
  Frame frame = setup.frame(o);
  frame.timed = !o.stats.empty();
  setup.status.say("drawing " + std::to_string(o.width) + " x " + std::to_string(o.height) + " pixels");
  setup.renderer->draw(setup.design.scene, setup.design.look, frame);
  const FrameStats stats = setup.renderer->measure();
  setup.status.clear();
  if (!stats.problem.empty()) return fail(kNoGraphics, stats.problem);
  if (asked != Method::kAuto && asked != stats.method) {
    std::fprintf(stderr, "weftlight: drawn by %s, the nearest method that is there\n",
                 std::string(method_name(stats.method)).c_str());
  }
  std::string error = write_picture(o.out, setup.renderer->read_back(writes_linear(o.out)));
  if (error.empty() && !o.stats.empty()) error = write_stats(o.stats, stats, setup.design.look.tolerance, o);
  return error.empty() ? kDone : not_written(error);
}

}  // namespace weftlight::commands
