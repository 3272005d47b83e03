// `weftlight render`: the lit, draped cloth as a picture, without a window.

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "commands/commands.h"
#include "files/files.h"
#include "light/ladder.h"
#include "preview/context.h"
#include "preview/pipeline.h"
#include "preview/renderer.h"
#include "wif/wif.h"

namespace weftlight {
namespace {

int fail(int code, const std::string& what) {
  std::fprintf(stderr, "weftlight: %s\n", what.c_str());
  return code;
}

void take_options(Design& design, const PictureOptions& o) {
  Scene& scene = design.scene;
  if (!o.mesh.empty()) scene.mesh = o.mesh;
  if (!std::isnan(o.view_azimuth)) scene.view_azimuth = o.view_azimuth, scene.view_elevation = o.view_elevation;
  if (!std::isnan(o.light_azimuth)) scene.light_azimuth = o.light_azimuth, scene.light_elevation = o.light_elevation;
  if (!o.method.empty()) design.look.method = method_from_name(o.method).value_or(Method::kAuto);
}

std::string write_picture(const std::string& path, Image image, bool linear) {
  if (linear) return write_image(path, image, PixelType::kHalf);
  // The picture is opaque: a PNG without alpha is smaller and reads everywhere.
  Image rgb{image.width, image.height, 3, {}};
  rgb.texels.reserve(image.texels.size() / 4 * 3);
  for (size_t i = 0; i < image.texels.size(); i += 4) {
    rgb.texels.insert(rgb.texels.end(), image.texels.begin() + static_cast<long>(i), image.texels.begin() + static_cast<long>(i + 3));
  }
  return write_image(path, rgb, PixelType::kU8);
}

std::string write_stats(const std::string& path, const FrameStats& stats, const PictureOptions& o) {
  const nlohmann::json json{{"method", method_name(stats.method)},
                            {"gpu_ms", stats.gpu_ms},
                            {"shaded_pixels", stats.shaded_pixels},
                            {"yarns_per_pixel", stats.yarns_per_pixel},
                            {"bytes", stats.texture_bytes},
                            {"width", o.width},
                            {"height", o.height}};
  return write_file_atomically(path, json.dump(2) + "\n");
}

}  // namespace

int render_command(const PictureOptions& o) {
  const std::string extension = std::filesystem::path(o.out).extension().string();
  if (extension != ".png" && extension != ".exr") return fail(kUsage, o.out + ": the picture must be a .png or an .exr");
  OpenedDesign opened = open_design(o.file);
  if (!opened.ok) return kBadInput;
  take_options(opened.design, o);

  std::string error;
  const std::unique_ptr<HeadlessContext> context = HeadlessContext::create(error);
  if (!context) return fail(kNoGraphics, "no graphics: " + error);
  const std::unique_ptr<Renderer> renderer = Renderer::create(error);
  if (!renderer) return fail(kNoGraphics, "no graphics: " + error);

  Pipeline pipeline;
  pipeline.submit(std::make_shared<const Design>(opened.design));
  error = pipeline.finish(*renderer);
  if (!error.empty()) return fail(kBadInput, error);

  Frame frame;
  frame.width = o.width, frame.height = o.height;
  frame.yarns_per_pixel = o.yarns_per_pixel;
  frame.front = o.face;
  renderer->draw(opened.design.scene, opened.design.look, frame);
  const FrameStats stats = renderer->measure();
  if (opened.design.look.method != Method::kAuto && opened.design.look.method != stats.method) {
    std::fprintf(stderr, "weftlight: drawn by %s, the nearest method that is there\n", std::string(method_name(stats.method)).c_str());
  }
  const bool linear = extension == ".exr";
  error = write_picture(o.out, renderer->read_back(linear), linear);
  if (!error.empty()) return fail(kNotWritten, error);
  if (!o.stats.empty()) error = write_stats(o.stats, stats, o);
  if (!error.empty()) return fail(kNotWritten, error);
  return kDone;
}

}  // namespace weftlight
