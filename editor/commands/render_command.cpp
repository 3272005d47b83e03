// `weftlight render`: the lit, draped cloth as a picture, without a window.

#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands/picture_setup.h"
#include "light/ladder.h"
#include "wif/wif.h"

namespace weftlight::commands {
namespace {

std::string write_stats(const std::string& path, const FrameStats& stats, const PictureOptions& o) {
  const nlohmann::json json{{"method", method_name(stats.method)},
                            {"gpu_ms", stats.gpu_ms},
                            {"hair_ms", stats.hair_ms},
                            {"hairs", stats.hairs},
                            {"shaded_pixels", stats.shaded_pixels},
                            {"yarns_per_pixel", stats.yarns_per_pixel},
                            {"bytes", stats.texture_bytes},
                            {"width", o.width},
                            {"height", o.height}};
  return write_file_atomically(path, json.dump(2) + "\n");
}

}  // namespace

int render_command(const PictureOptions& o) {
  PictureSetup setup;
  if (const int code = setup.open(o); code != kDone) return code;
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
  if (error.empty() && !o.stats.empty()) error = write_stats(o.stats, stats, o);
  return error.empty() ? kDone : fail(kNotWritten, error);
}

}  // namespace weftlight::commands
