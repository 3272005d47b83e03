// The cloth as it hangs, drawn and traced.

#include <cmath>
#include <limits>

#include "command.h"
#include "commands/picture_setup.h"
#include "gl/open_headless.h"
#include "scene/camera.h"
#include "scene/named_views.h"

namespace weftlight::orientation {

using base::problem_of;
using design::Method, design::Scene, design::method_name;
using draft::Face;
using drape::Mesh;
using files::Image;
using gl::Frame;
using scene::Camera, scene::bounds_of, scene::drawn_scene, scene::place_camera, scene::view_named;

namespace {

using commands::PictureOptions, commands::PictureSetup, commands::kDone;

constexpr int kWidth = 240, kHeight = 180;
constexpr float kYarnsPerPixel = 0.08f;

PictureOptions options_of(const Workplace& at, const std::string& out) {
  PictureOptions o;
  o.file = at.draft(), o.out = at.scratch / out, o.mesh = "plane";
  o.width = kWidth, o.height = kHeight, o.yarns_per_pixel = kYarnsPerPixel;
  o.view_azimuth = o.view_elevation = 0;
  o.light_azimuth = -20, o.light_elevation = 40;
  o.exposure_ev = 0;
  return o;
}

/// The pixels of a repeat in the middle of a plane, seen from before or from behind.
Seen on_plane(std::string name, Image image, const Scene& scene, float yarns_per_pixel, Face face) {
  const Mesh plane = *files::load_drape("plane");
  const Camera camera = place_camera(scene, plane, bounds_of(plane), image.width, image.height, yarns_per_pixel, 1);
  const auto pixel = [&](float u, float v) {
    const glm::vec2 at = glm::vec2(plane.position_mm[0]) + plane.uv_mm[0] - glm::vec2(u, v);
    const glm::vec4 clip = camera.world_to_clip * glm::vec4(at, 0, 1);
    return glm::dvec2((0.5 + 0.5 * static_cast<double>(clip.x / clip.w)) * image.width,
                      (0.5 - 0.5 * static_cast<double>(clip.y / clip.w)) * image.height);
  };
  // The repeat that holds the middle.
  const glm::vec2 middle = -0.5f * glm::vec2(300, 200);
  const float u = std::floor(middle.x / kEnds) * kEnds, v = std::floor(middle.y / kPicks) * kPicks;
  const glm::dvec2 first = pixel(u, v), last = pixel(u + kEnds, v + kPicks);
  Seen s{std::move(name), std::move(image)};
  s.x = std::min(first.x, last.x), s.width = std::abs(last.x - first.x);
  s.y = std::min(first.y, last.y), s.height = std::abs(last.y - first.y);
  EXPECT_TRUE(s.x >= 0 && s.y >= 0 && s.x + s.width <= s.image.width && s.y + s.height <= s.image.height) << s.name;
  s.face = face;
  return std::move(s).from(first.x<last.x, first.y> last.y);
}

}  // namespace

std::vector<Seen> rendered_cloths(const Workplace& at, std::string& skipped) {
  if (const auto context = gl::open_headless(); !context) {
    skipped = "no graphics: " + problem_of(context);
    return {};
  }
  PictureSetup setup;
  const PictureOptions options = options_of(at, "cloth.png");
  EXPECT_EQ(setup.open(options), kDone);
  if (!setup.renderer) return {};
  std::vector<Seen> out;
  const auto draw = [&](const std::string& name, const Scene& scene, const Frame& frame, Method method) {
    setup.design.look.method = method;
    setup.renderer->draw(scene, setup.design.look, frame);
    const bool behind = std::abs(scene.view_azimuth) > 90;
    const Face face = (frame.front == Face::kFront) != behind ? Face::kFront : Face::kBack;
    Seen s = on_plane(name + " " + std::string(method_name(method)), setup.renderer->read_back(), scene,
                      frame.yarns_per_pixel, face);
    EXPECT_EQ(s.end1_left, behind) << s.name;
    EXPECT_FALSE(s.pick1_bottom) << s.name;
    out.push_back(std::move(s));
  };
  Frame frame = setup.frame(options);
  Scene behind = setup.design.scene;
  behind.view_azimuth = 180, behind.light_azimuth = 160;
  for (const Method method : {Method::kAuto, Method::kYarn, Method::kVrst03, Method::kFlat}) {
    frame.front = Face::kFront;
    draw("front", setup.design.scene, frame, method);
    draw("from behind", behind, frame, method);
    frame.front = Face::kBack;
    draw("back", setup.design.scene, frame, method);
  }
  frame.front = Face::kFront, frame.yarns_per_pixel = 0;
  frame.width = 640, frame.height = 520;  // for a whole repeat of threads as large as the flat views have them near by
  for (const char* view : {"head_on", "near"}) {
    const Scene flat = drawn_scene(*view_named(setup.design, view, 640, 520));
    draw(view, flat, frame, Method::kAuto);
  }
  return out;
}

std::vector<Seen> traced_cloths(const Workplace& at, std::string& skipped) {
  if (const auto context = gl::open_headless(); !context) {
    skipped = "no graphics: " + problem_of(context);
    return {};
  }
  std::vector<Seen> out;
  for (const Face face : {Face::kFront, Face::kBack}) {
    const std::string path = at.scratch / "traced.png";
    run({"reference",
         at.draft(),
         "-o",
         path,
         "--mesh",
         "plane",
         "--size",
         "120x90",
         "--yarns-per-pixel",
         "0.16",
         "--view",
         "0,0",
         "--light",
         "-20,40",
         "--exposure",
         "0",
         "--spp",
         "4",
         "--face",
         face == Face::kFront ? "front" : "back"});
    Scene scene = marked_design().scene;
    scene.view_azimuth = scene.view_elevation = 0;
    out.push_back(on_plane(face == Face::kFront ? "front" : "back", picture(path), scene, 0.16f, face));
  }
  return out;
}

}  // namespace weftlight::orientation
