#include "gl/renderer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <map>

#include "gl/average.h"
#include "gl/gpu_cloth.h"
#include "gl/gpu_flyaways.h"
#include "gl/gpu_mesh.h"
#include "gl/ground_light.h"
#include "gl/render_target.h"
#include "gl/shader_program.h"
#include "gl/sun_shadow.h"
#include "light/formulas.h"
#include "light/lod_table.h"
#include "render_data/camera.h"
#include "render_data/exposure.h"
#include "render_data/method_weights.h"
#include "render_data/shipped_lod_table.h"

namespace weftlight::gl {
namespace {

constexpr int kFullTaps = 12, kQuickTaps = 4;
// Rungs that a program of `auto` holds.
constexpr int kYarnMethod = 1, kCellMethod = 2, kRepeatMethod = 4, kAllMethods = 15;
constexpr float kFullRadius = 2.2f, kQuickRadius = 1.6f;  // of the shadow's filter, texels

interop::vec4 vec(glm::vec3 v, float w) { return {v.x, v.y, v.z, w}; }

struct DrawnFrame {
  Scene scene;
  Look look;
  Frame frame;
  int methods = kAllMethods;
  bool gaps = false;  // what is behind shows
  SceneLight light{};
};

/// The rung that is drawn for a rung that is asked for: the truth is drawn by the ray tracer.
Method drawn_method(Method asked) { return asked == Method::kReference ? Method::kAuto : asked; }

}  // namespace

struct Renderer::Parts {
  GpuMesh mesh, patch;
  GpuCloth cloth;
  LightRig rig;
  GlTexture environment;  // the rig's picture, if it has one
  SunShadow sun;
  GroundLight ground;
  GpuFlyaways flyaways;
  Target screen{false}, linear{true};
  Average average;
  GlBuffer frame_block;
  GlVertexArray nothing;  // for shapes that the vertex shader makes
  /// Compiled when a picture first needs it; one that does not compile is not tried again.
  struct ClothProgram {
    GlProgram program;
    std::string problem;
  };
  std::map<std::array<int, 7>, ClothProgram> cloth_programs;
  GlProgram backdrop, body;
  GlQuery timer, samples, hair_timer;
  bool queried = false, flyaways_queried = false, software = false;
  double software_ms = 0, software_hair_ms = 0;
  FrameStats stats;
  DrawnFrame last;
  ShippedLodTable shipped = shipped_lod_table();
  LodTable asked = shipped.lod_table, lod_table = asked;  // of any cloth, and fitted to this one

  bool build(std::string& error);
  void set_lights(LightRig lights);
  const ClothProgram& cloth_program(Method method, int taps, int methods, bool more_lit, ThreadKind kind = {});
  int methods_of(const DrawnFrame& drawn, const GpuMesh& on, const Camera& camera);
  void tell_methods(const DrawnFrame& drawn);
  Plan plan_for(const DrawnFrame& drawn) const;
  interop::FrameData frame_data(const DrawnFrame& drawn, const Camera& camera, bool linear_out,
                                const GpuMesh& on) const;
  void put_lights(const DrawnFrame& drawn, const Camera& camera, interop::FrameData& data) const;
  void upload_frame(const interop::FrameData& data);
  void draw_scene(const DrawnFrame& drawn, Target& target, bool linear_out);
  void draw_cloth(const DrawnFrame& drawn, GpuMesh& on);
  void draw_hairs(const DrawnFrame& drawn, const Camera& camera);
  void draw_patch(const FlatPatch& patch, const Look& look);
  std::chrono::steady_clock::time_point clock_here(const Frame& frame) const;
  void draw_around(const DrawnFrame& drawn, const Camera& camera);
  /// Share of the key light that the cloth keeps from what is behind it.
  float opacity() const { return std::min(1.0f, cloth.data().systems[0].coverage + cloth.data().systems[1].coverage); }
  std::array<glm::vec4, 6> ground_drawn{};  // what the light on the ground was made by
  MethodWeights shares;                     // of the last picture
  void fit_lod_table() { lod_table = fitted(asked, cloth.errors()); }
  bool has_gaps() const;
  void take_queries(bool wait);
};

bool Renderer::Parts::build(std::string& error) {
  const char* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  software = name && (std::strstr(name, "llvmpipe") || std::strstr(name, "softpipe"));
  rig = load_light_rig("studio", error);
  if (!error.empty()) return false;
  const std::vector<std::string> taps{"SHADOW_TAPS " + std::to_string(kFullTaps)};
  backdrop = build_program("backdrop.vert", "backdrop.frag", taps, error);
  if (!error.empty()) return false;
  body = build_program("body.vert", "body.frag", taps, error);
  if (!error.empty() || !sun.build(error) || !ground.build(error) || !flyaways.build(error) || !average.build(error))
    return false;
  // Without a graphics card the first picture is a quick one, by a program of its own.
  error = software ? cloth_program(Method::kAuto, kQuickTaps, kRepeatMethod, false).problem
                   : cloth_program(Method::kAuto, kFullTaps, kAllMethods & ~kCellMethod, false).problem;
  return error.empty();
}

/// Which rungs and how many samples a picture takes, by footprint. What moves is given two samples at the most: a
/// blurred thread hides more than a rough one.
Plan Renderer::Parts::plan_for(const DrawnFrame& drawn) const {
  constexpr int kMoving = 2;
  const bool moving = drawn.frame.render_scale < 1;
  const int all = moving ? std::min(kMoving, drawn.frame.all_samples) : drawn.frame.all_samples;
  Plan plan = plan_of(lod_table, {drawn.look.tolerance, all});
  plan.samples = std::min(all, drawn.frame.samples);
  if (drawn.frame.exact_samples) plan.lattices = {};
  const bool straight_to_repeat = plan.methods[1] <= plan.methods[0];
  if (!cloth.has_threads()) plan.methods[0] = 0;
  if (straight_to_repeat) plan.methods[1] = plan.methods[0];
  // One answer for all the cloth holds where its pattern is no longer seen, and there it is the better: measured for
  // this cloth, not by footprint.
  plan.methods[2] = std::max(plan.methods[1], cloth.data().even_yarns);
  return plan;
}

/// more_lit: with the lights of an environment beside the key light. kind: the cloth that it is for.
const Renderer::Parts::ClothProgram& Renderer::Parts::cloth_program(Method method, int taps, int methods, bool more_lit,
                                                                    ThreadKind kind) {
  ClothProgram& made =
      cloth_programs[{static_cast<int>(method), taps, methods, more_lit, kind.even, kind.one_layer, kind.smooth}];
  if (!made.program.preview_bake() && made.problem.empty()) {
    const std::string name(method_name(method));
    std::vector<std::string> defines{"METHOD " + name, "SHADE shade_" + name, "SHADOW_TAPS " + std::to_string(taps),
                                     "SHADOW_AZIMUTHS " + std::to_string(kShadowAzimuths),
                                     "METHODS " + std::to_string(methods)};
    if (taps == kQuickTaps) defines.push_back("QUICK");
    if (more_lit) defines.push_back("MORE_LIT");
    if (kind.even) defines.push_back("EVEN_THREADS");
    if (kind.one_layer) defines.push_back("ONE_LAYER");
    if (kind.smooth) defines.push_back("SMOOTH_YARNS");
    made.program = build_program("cloth.vert", "cloth.frag", defines, made.problem);
    if (!made.problem.empty()) made.problem = name + ": " + made.problem;
  }
  return made;
}

/// Lights, sky, and what of an environment shows behind the cloth.
void Renderer::Parts::put_lights(const DrawnFrame& drawn, const Camera& camera, interop::FrameData& data) const {
  const std::vector<DistantLight>& lights = drawn.light.lights;
  if (!lights.empty()) {
    data.light = vec(lights[0].towards, lights[0].radius);
    data.light_color = vec(lights[0].irradiance, 0);
  }
  for (size_t i = 1; i < lights.size(); ++i) {
    const ShadowView& view = sun.more(i);
    data.world_to_more[i - 1] = view.world_to_shadow;
    data.more_light[i - 1] = vec(lights[i].towards, lights[i].radius);
    data.more_color[i - 1] = vec(lights[i].irradiance, view.texel_mm);
    data.picture.w = static_cast<float>(i);
  }
  for (size_t i = 0; i < drawn.light.sky.size(); ++i) data.sky[i] = vec(drawn.light.sky[i], 0);
  const glm::mat4 clip_to_world = glm::inverse(camera.world_to_clip);
  const auto ray = [&](float x, float y) {
    const glm::vec4 far = clip_to_world * glm::vec4(x, y, 1, 1);
    return glm::vec3(far) / far.w - camera.eye;
  };
  const glm::vec3 middle = ray(0, 0);
  const float turn = glm::radians(drawn.scene.light_azimuth);
  const bool shown = drawn.scene.surroundings && rig.environment && !drawn.frame.transparent;
  data.look[0] = vec(ray(1, 0) - middle, std::cos(turn));
  data.look[1] = vec(ray(0, 1) - middle, std::sin(turn));
  data.look[2] = vec(middle, shown ? 1.0f : 0.0f);
}

void Renderer::Parts::set_lights(LightRig lights) {
  rig = std::move(lights);
  environment.reset();
  if (!rig.environment) return;
  const Image& picture = rig.environment->picture();
  glBindTexture(GL_TEXTURE_2D, environment.get());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, picture.width, picture.height, 0, GL_RGB, GL_FLOAT, picture.texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

interop::FrameData Renderer::Parts::frame_data(const DrawnFrame& drawn, const Camera& camera, bool linear_out,
                                               const GpuMesh& on) const {
  const Scene& scene = drawn.scene;
  const PreparedMesh& prepared = on.prepared();
  interop::FrameData data{};
  data.world_to_clip = camera.world_to_clip;
  data.world_to_shadow = sun.world_to_shadow();
  data.eye = vec(camera.eye, drawn.frame.front == Face::kFront ? 1.0f : -1.0f);
  put_lights(drawn, camera, data);
  data.light_color.w = std::exp2(linear_out ? drawn.look.exposure_ev : stats.exposure_ev);
  const Linear background = linear_from_srgb(scene.background);
  data.background = {background.r, background.g, background.b, drawn.frame.transparent ? 1.0f : 0.0f};
  data.picture = {static_cast<float>(drawn.frame.width), static_cast<float>(drawn.frame.height),
                  linear_out ? 1.0f : 0.0f, data.picture.w};
  const Plan plan = plan_for(drawn);
  data.samples = {static_cast<float>(std::max(0, drawn.frame.pass)), static_cast<float>(std::max(1, plan.samples)), 0,
                  0};
  data.lattices[0] = glm::make_vec4(plan.lattices.data());
  data.lattices[1] = glm::make_vec4(plan.lattices.data() + 4);
  const bool quick = drawn.frame.render_scale < 1;
  data.shadow = {1.0f / static_cast<float>(sun.size()), quick ? kQuickRadius : kFullRadius, sun.texel_mm() * 3.4f,
                 opacity()};
  const std::array<double, 2> period{std::max(1e-6, static_cast<double>(cloth.width_mm())),
                                     std::max(1e-6, static_cast<double>(cloth.depth_mm()))};
  for (size_t a = 0; a < 2; ++a) {
    const double repeats = on.uv_origin_mm()[a] / period[a];
    data.tile[static_cast<int>(a)] = static_cast<float>(1 / period[a]);
    data.tile[static_cast<int>(a) + 2] = static_cast<float>(repeats - std::floor(repeats));
  }
  const glm::vec3 centre = prepared.bounds.centre();
  data.ground = {prepared.ground_mm, prepared.ground_half_mm, centre.x, centre.z};
  data.methods = {plan.methods[0], plan.methods[1], plan.methods[2], drawn.frame.false_color_methods ? 1.0f : 0.0f};
  const FlyawayGrowth growth = flyaway_growth(cloth.data(), drawn.frame.front);
  data.hair = {static_cast<float>(flyaway_pieces(growth, camera.pixel_mm)), 0, growth.length_mm[0],
               growth.length_mm[1]};
  return data;
}

void Renderer::Parts::upload_frame(const interop::FrameData& data) {
  glBindBuffer(GL_UNIFORM_BUFFER, frame_block.get());
  glBufferData(GL_UNIFORM_BUFFER, sizeof data, &data, GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, frame_block.get());
}

/// Now, with all that was asked of a software renderer done: its timer query counts one tile alone.
std::chrono::steady_clock::time_point Renderer::Parts::clock_here(const Frame& frame) const {
  if (software && frame.timed) glFinish();
  return std::chrono::steady_clock::now();
}

void Renderer::Parts::draw_cloth(const DrawnFrame& drawn, GpuMesh& on) {
  stats.problem.clear();
  if (cloth.empty() || !drawn.frame.cloth) return;
  cloth.bind();
  Method method = drawn_method(drawn.look.method);
  if (method_facts(method).threads && !cloth.has_threads()) method = Method::kCell;
  const int taps = drawn.frame.render_scale < 1 ? kQuickTaps : kFullTaps;
  const bool of_threads = method_facts(method).threads || (method == Method::kAuto && (drawn.methods & kYarnMethod));
  const ClothProgram& with = cloth_program(method, taps, drawn.methods, drawn.light.lights.size() > 1,
                                           software && of_threads ? cloth.thread_kind() : ThreadKind{});
  stats.problem = with.problem;
  if (!with.problem.empty()) return;
  glUseProgram(with.program.preview_bake());
  drawn.gaps ? glEnable(GL_BLEND) : glDisable(GL_BLEND);
  take_queries(queried);
  const auto start = clock_here(drawn.frame);
  glBeginQuery(GL_TIME_ELAPSED, timer.get());
  glBeginQuery(GL_SAMPLES_PASSED, samples.get());
  on.draw_cloth();
  glEndQuery(GL_SAMPLES_PASSED);
  glEndQuery(GL_TIME_ELAPSED);
  queried = true;
  if (software && drawn.frame.timed) {
    software_ms = std::chrono::duration<double, std::milli>(clock_here(drawn.frame) - start).count();
  }
}

/// The rungs of ours have stray fibres; the seed's row and the baselines show what they show. While something moves
/// there are none: the mesh is a coarser one then, and they would float beside it.
bool has_hairs(const DrawnFrame& drawn) {
  const Method method = drawn_method(drawn.look.method);
  const bool ours = method == Method::kAuto || method == Method::kYarn || method == Method::kCell ||
                    method == Method::kRepeat || method == Method::kCloth;
  return ours && drawn.frame.cloth && drawn.frame.render_scale >= 1 && !drawn.frame.false_color_methods;
}

/// Over everything else, since what is behind shows between them.
void Renderer::Parts::draw_hairs(const DrawnFrame& drawn, const Camera& camera) {
  stats.flyaways = 0;
  if (cloth.empty() || !has_hairs(drawn)) {
    stats.flyaway_ms = 0;
    return;
  }
  const auto start = clock_here(drawn.frame);
  const FlyawayGrowth growth = flyaway_growth(cloth.data(), drawn.frame.front);
  flyaways.sow(mesh, growth,
               {camera.world_to_clip, camera.eye, static_cast<float>(drawn.frame.width),
                static_cast<float>(drawn.frame.height)});
  stats.flyaways = flyaways.count();
  cloth.bind();
  sun.bind();
  glBeginQuery(GL_TIME_ELAPSED, hair_timer.get());
  flyaways.draw(flyaway_pieces(growth, camera.pixel_mm));
  glEndQuery(GL_TIME_ELAPSED);
  flyaways_queried = true;
  if (software && drawn.frame.timed) {
    software_hair_ms = std::chrono::duration<double, std::milli>(clock_here(drawn.frame) - start).count();
  }
}

/// Backdrop, ground and what the cloth hangs on.
void Renderer::Parts::draw_around(const DrawnFrame& drawn, const Camera& camera) {
  glUseProgram(body.preview_bake());
  glDisable(GL_BLEND);
  mesh.draw_body();
  glBindVertexArray(nothing.get());
  if (!drawn.frame.transparent) {
    glUseProgram(backdrop.preview_bake());
    glActiveTexture(GL_TEXTURE0 + kEnvironmentSlot);
    glBindTexture(GL_TEXTURE_2D, environment.preview_bake());
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  if (drawn.frame.ground && camera.eye.y > mesh.prepared().ground_mm) ground.draw();
}

void Renderer::Parts::draw_scene(const DrawnFrame& drawn, Target& target, bool linear_out) {
  const PreparedMesh& prepared = mesh.prepared();
  const Camera camera = place_camera(drawn.scene, prepared.mesh, prepared.bounds, drawn.frame.width, drawn.frame.height,
                                     drawn.frame.yarns_per_pixel, cloth.mean_spacing_mm());
  stats.method = drawn_method(drawn.look.method);
  stats.exposure_ev = exposure_stops(drawn.look, cloth.data(), rig);
  DrawnFrame chosen = drawn;
  chosen.methods = methods_of(drawn, mesh, camera);
  chosen.gaps = has_gaps();
  chosen.light = scene_light(rig, drawn.scene);
  mesh.sort(camera.eye, chosen.gaps ? TriangleOrder::kBackToFront : TriangleOrder::kFrontToBack,
            drawn.frame.render_scale < 1);
  const bool new_light = sun.update(mesh, chosen.light.lights[0].towards, frame_block);
  sun.update_more(mesh, chosen.light.lights, frame_block);
  const interop::FrameData data = frame_data(chosen, camera, linear_out, mesh);
  upload_frame(data);
  const std::array<glm::vec4, 6> on_ground{
      data.light, vec(data.light_color, opacity()), data.sky[0], data.sky[1], data.sky[6], data.sky[8]};
  if (new_light || on_ground != ground_drawn) ground.update(sun.depth(), mesh.ground_sky());
  ground_drawn = on_ground;
  if (!target.begin(drawn.frame.width, drawn.frame.height, drawn.frame.render_scale)) return;
  sun.bind();
  glClearColor(0, 0, 0, 0);
  glDepthMask(GL_TRUE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  // What shows through gaps must be there before; otherwise what the cloth hides need not be shaded.
  if (chosen.gaps) draw_around(drawn, camera);
  draw_cloth(chosen, mesh);
  if (!chosen.gaps) draw_around(drawn, camera);
  draw_hairs(drawn, camera);
  glBindVertexArray(0);
  target.end();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  stats.texture_bytes = cloth.bytes();
  stats.yarns_per_pixel = cloth.mean_spacing_mm() > 0 ? camera.pixel_mm / cloth.mean_spacing_mm() : 0;
}

/// Whether what is behind shows: through open cloth, and near by through the pinholes that any weave has, too
/// small for the maps.
bool Renderer::Parts::has_gaps() const {
  constexpr float kFew = 0.01f;
  if (cloth.data().open > 0.5f) return true;
  return method_facts(stats.method).threads || (stats.method == Method::kAuto && stats.method_weights[0] > kFew);
}

/// Which rungs the program of auto must hold. Without a graphics card both sides of a branch are run, so it holds what
/// this picture needs; a card has one program, so that no view waits for another.
int Renderer::Parts::methods_of(const DrawnFrame& drawn, const GpuMesh& on, const Camera& camera) {
  const float scale = drawn.frame.render_scale;
  const auto pixels = [scale](int n) { return static_cast<int>(std::lround(scale * static_cast<float>(n))); };
  const Plan plan = plan_for(drawn);
  shares = method_weights(on.prepared(), camera, pixels(drawn.frame.width), pixels(drawn.frame.height),
                          cloth.mean_spacing_mm(), plan.methods);
  tell_methods(drawn);
  if (stats.method != Method::kAuto || shares.yarns_per_pixel <= 0) return kAllMethods;
  if (scale < 1) {
    // While the view moves: one rung for the whole picture, the finest that a fair part of it needs.
    constexpr float kFairPart = 0.05f;
    return shares.of[0] > kFairPart ? kYarnMethod : shares.of[1] > kFairPart ? kCellMethod : kRepeatMethod;
  }
  if (!software) return plan.methods[0] < plan.methods[1] ? kAllMethods : kAllMethods & ~kCellMethod;
  int needed = 0;
  for (size_t k = 0; k < shares.needed.size(); ++k) needed |= shares.needed[k] ? 1 << k : 0;
  return needed;
}

/// Shares of the rungs and the error to expect; of several passes when all are drawn.
void Renderer::Parts::tell_methods(const DrawnFrame& drawn) {
  stats.method_weights = shares.of;
  stats.estimated_error = 0;
  const float yarns = shares.yarns_per_pixel;
  if (yarns <= 0) return;
  Plan plan = plan_for(drawn);
  if (drawn.frame.pass >= 0) plan.samples = drawn.frame.all_samples;
  constexpr std::array<Method, 4> kDrawn{Method::kYarn, Method::kCell, Method::kRepeat, Method::kCloth};
  const auto error_of = [&](Method m) {
    const float error = expected_error(lod_table, m, yarns, m == Method::kYarn ? samples_at(plan, yarns) : 1);
    return std::isfinite(error) ? error : 0.0f;
  };
  if (stats.method != Method::kAuto) {
    stats.estimated_error = error_of(stats.method);
    return;
  }
  for (size_t k = 0; k < kDrawn.size(); ++k) stats.estimated_error += shares.of[k] * error_of(kDrawn[k]);
}

void Renderer::Parts::draw_patch(const FlatPatch& p, const Look& look) {
  patch.upload(patch_mesh(p));
  const Camera camera = patch_camera(p);
  DrawnFrame drawn{{}, look, {}};
  drawn.scene.sky_strength = 0;
  drawn.frame.width = p.width, drawn.frame.height = p.height, drawn.frame.timed = true;
  if (p.samples > 0) drawn.frame.samples = p.samples, drawn.frame.exact_samples = true;
  drawn.frame.pass = p.pass;
  drawn.frame.front = p.face;
  if (!linear.begin(p.width, p.height, 1)) return;
  interop::FrameData data = frame_data(drawn, camera, true, patch);
  data.light = vec(p.light_towards, p.light_sine);
  data.light_color = vec(p.light_irradiance, 1);
  // 0.5 + 0.5 of the cosine about sky_towards, in spherical harmonics.
  const glm::vec3 rise = 0.5f * p.sky / 0.488603f * p.sky_towards;
  data.sky[0] = vec(glm::vec3(0.5f * p.sky / 0.282095f), 0), data.sky[1] = vec(glm::vec3(rise.y), 0);
  data.sky[2] = vec(glm::vec3(rise.z), 0), data.sky[3] = vec(glm::vec3(rise.x), 0);
  // Every point falls beyond the border of the shadow map, where it is lit.
  data.world_to_shadow = glm::mat4(0.0f);
  data.world_to_shadow[3] = {2, 2, 0, 1};
  upload_frame(data);
  sun.bind();
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  stats.method = drawn_method(look.method);
  drawn.methods = methods_of(drawn, patch, camera);
  draw_cloth(drawn, patch);
  glBindVertexArray(0);
  linear.end();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  stats.texture_bytes = cloth.bytes();
}

void Renderer::Parts::take_queries(bool wait) {
  if (!queried) return;
  GLuint ready = GL_FALSE;
  if (!wait) glGetQueryObjectuiv(samples.get(), GL_QUERY_RESULT_AVAILABLE, &ready);
  if (!wait && !ready) return;
  GLuint64 ns = 0, passed = 0;
  glGetQueryObjectui64v(timer.get(), GL_QUERY_RESULT, &ns);
  glGetQueryObjectui64v(samples.get(), GL_QUERY_RESULT, &passed);
  stats.gpu_ms = software ? software_ms : static_cast<double>(ns) * 1e-6;
  stats.shaded_pixels = static_cast<double>(passed) / 4;  // four samples a pixel
  queried = false;
  if (!flyaways_queried) return;
  GLuint64 hair_ns = 0;
  glGetQueryObjectui64v(hair_timer.get(), GL_QUERY_RESULT, &hair_ns);
  stats.flyaway_ms = software ? software_hair_ms : static_cast<double>(hair_ns) * 1e-6;
  flyaways_queried = false;
}

Renderer::Renderer() : parts_(std::make_unique<Parts>()) {}
Renderer::~Renderer() = default;

std::unique_ptr<Renderer> Renderer::create(std::string& error) {
  if (epoxy_gl_version() < 33) {
    error = "OpenGL 3.3 is needed: update the graphics driver";
    return nullptr;
  }
  std::unique_ptr<Renderer> made(new Renderer);
  return made->parts_->build(error) ? std::move(made) : nullptr;
}

void Renderer::set_mesh(PreparedMesh mesh) {
  parts_->mesh.upload(std::move(mesh));
  parts_->sun.forget();
  parts_->flyaways.forget();
}
void Renderer::set_lights(LightRig lights) { parts_->set_lights(std::move(lights)); }
const std::vector<std::string>& Renderer::light_remarks() const { return parts_->rig.remarks; }
void Renderer::upload(const PackedCloth& cloth) {
  parts_->cloth.upload(cloth);
  parts_->fit_lod_table();
}
void Renderer::upload(PackedCloth&& cloth) {
  parts_->cloth.upload(std::move(cloth));
  parts_->fit_lod_table();
}
void Renderer::upload(const ClothPatches& patches) { parts_->cloth.upload(patches); }
void Renderer::upload_lobes(const ClothLobes& lobes) {
  parts_->cloth.upload_lobes(lobes);
  parts_->fit_lod_table();
}

FrameStats Renderer::draw(const Scene& scene, const Look& look, const Frame& frame) {
  parts_->last = {scene, look, frame, kAllMethods, false, {}};
  Target& screen = parts_->screen;
  parts_->draw_scene(parts_->last, screen, false);
  if (frame.pass >= 0)
    parts_->average.add(screen.texture(), screen.framebuffer(), frame.width, frame.height, frame.share);
  parts_->take_queries(false);
  return parts_->stats;
}

FrameStats Renderer::measure() {
  parts_->take_queries(true);
  return parts_->stats;
}

unsigned Renderer::texture() const { return parts_->screen.texture(); }

Image Renderer::read_back(bool linear) const {
  if (!linear) return parts_->screen.read();
  parts_->draw_scene(parts_->last, parts_->linear, true);
  return parts_->linear.read();
}

void Renderer::read_pixels(std::vector<uint32_t>& pixels) const { parts_->screen.read(pixels); }

float Renderer::tolerance_within(float budget_ms) {
  const FrameStats& s = measure();
  const float pixels = static_cast<float>(s.shaded_pixels);
  const DrawnFrame& drawn = parts_->last;
  const LodDemand demand{drawn.look.tolerance, drawn.frame.all_samples};
  const float expected = expected_ms(parts_->lod_table, parts_->shares, pixels, demand);
  if (s.gpu_ms <= 0 || expected <= 0) return 0;
  return render_data::tolerance_within(parts_->lod_table, parts_->shares, pixels,
                                       static_cast<float>(s.gpu_ms) / expected, budget_ms);
}

void Renderer::set_lod_table(const LodTable& lod_table) {
  parts_->asked = lod_table;
  parts_->fit_lod_table();
}
SeenPart Renderer::seen() const {
  SeenPart seen = seen_part(parts_->shares, parts_->cloth.mean_spacing_mm());
  seen.pixel_mm *= parts_->last.frame.render_scale;
  return seen;
}

bool Renderer::is_software() const { return parts_->software; }
const std::string& Renderer::lod_table_problem() const { return parts_->shipped.problem; }

std::string Renderer::device() const {
  return std::string(reinterpret_cast<const char*>(glGetString(GL_RENDERER))) + ", OpenGL " +
         reinterpret_cast<const char*>(glGetString(GL_VERSION));
}

void Renderer::draw_patch(const FlatPatch& patch, const Look& look) { parts_->draw_patch(patch, look); }
Image Renderer::read_patch() const { return parts_->linear.read(); }

}  // namespace weftlight::gl
