#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "../relative_rms.h"
#include "gl/shader_program.h"
#include "picture.h"
#include "render_data/method_weights.h"
#include "render_data/thread_block.h"
#include "scene/camera.h"
#include "wif/wif.h"

namespace weftlight::gl {

using base::presets_dir, base::problem_of, base::shaders_dir;
using design::Design, design::Method;
using draft::Face, draft::Rgb;
using drape::Mesh;
using files::Image;
using render_data::PackedCloth, render_data::PreparedMesh, render_data::StageResult, render_data::Stages,
    render_data::method_weights, render_data::prepare_mesh, render_data::square, render_data::twill;
using scene::Camera, scene::load_light_rig, scene::place_camera;

namespace {

constexpr Rgb kRed{0.8f, 0.1f, 0.1f}, kBlue{0.1f, 0.15f, 0.8f}, kWhite{0.9f, 0.9f, 0.9f};

double middle_alpha(const Image& image) {
  double sum = 0;
  for (int y = image.height / 4; y < image.height * 3 / 4; ++y) {
    for (int x = image.width / 4; x < image.width * 3 / 4; ++x)
      sum += static_cast<double>(image.texels[(static_cast<size_t>(y) * image.width + x) * 4 + 3]);
  }
  return sum / (image.width / 2.0) / (image.height / 2.0);
}

void expect_finite(const Image& image) {
  for (const float v : image.texels) {
    ASSERT_TRUE(std::isfinite(v));
    ASSERT_GE(v, 0.0f);
  }
}

/// A square that faces +z with a low wall on it, which stands a fiftieth off upright.
Mesh walled_square() {
  Mesh mesh = square(100);
  const auto first = static_cast<uint32_t>(mesh.position_mm.size());
  for (const float z : {0.0f, 3.0f}) {
    for (const float y : {0.0f, 100.0f}) {
      mesh.position_mm.push_back({20 + y / 50, y, z});
      mesh.normal.push_back({1, 0, 0});
      mesh.tangent.push_back({0, 0, 1});
      mesh.uv_mm.push_back({z, y});
    }
  }
  mesh.index.insert(mesh.index.end(), {first, first + 1, first + 3, first, first + 3, first + 2});
  return mesh;
}

/// Where along row y of a picture its green falls below half that of the left of the row, in pixels.
double shadow_starts(const Image& image, int y) {
  const auto green = [&](int x) {
    return static_cast<double>(image.texels[(static_cast<size_t>(y) * image.width + static_cast<size_t>(x)) * 4 + 1]);
  };
  int x = image.width / 4;
  const double half = 0.5 * green(x);
  while (x + 1 < image.width && green(x) >= half) ++x;
  return x - (half - green(x)) / std::max(green(x - 1) - green(x), 1e-9);
}

/// RMS distance of evenly spaced values from the straight line through them.
double roughness(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  double mean = 0, moment = 0, square_sum = 0;
  for (const double v : values) mean += v / count;
  for (size_t i = 0; i < values.size(); ++i) {
    const double at = static_cast<double>(i) - 0.5 * (count - 1);
    moment += at * (values[i] - mean);
    square_sum += (values[i] - mean) * (values[i] - mean);
  }
  const double spread = count * (count * count - 1) / 12;
  return std::sqrt(std::max(square_sum - moment * moment / spread, 0.0) / count);
}

TEST_F(PictureTest, WhileItsShadersAreCompiledACoarserPictureIsShown) {
  auto made = Renderer::create();
  ASSERT_TRUE(made);
  std::swap(renderer, *made);
  upload(twill(4, 2, kRed, kBlue), square(20));
  frame.at_once = true;
  renderer->hold_programs(true);
  const Image coarse = draw();
  EXPECT_TRUE(renderer->measure().compiling);
  EXPECT_GT(middle(coarse).sum(), 0.1) << "nothing was drawn";
  frame.at_once = false;
  const Image waited = draw();
  EXPECT_FALSE(renderer->measure().compiling) << "a picture that can wait was drawn coarser";
  frame.at_once = true;
  renderer->hold_programs(false);
  EXPECT_EQ(draw().texels, waited.texels);
  EXPECT_FALSE(renderer->measure().compiling);
  EXPECT_NE(coarse.texels, waited.texels);
  std::swap(renderer, *made);
}

TEST_F(PictureTest, AProgramMayBeCompiledAside) {
  auto begun = CompilingProgram::begin("backdrop.vert", "backdrop.frag", {"SHADOW_TAPS 4"});
  ASSERT_TRUE(begun) << problem_of(begun);
  while (!begun->is_done()) std::this_thread::yield();
  const auto built = begun->finished();
  ASSERT_TRUE(built) << problem_of(built);
  EXPECT_NE(built->name(), 0u);
  auto missing = CompilingProgram::begin("backdrop.vert", "no_such.frag", {});
  EXPECT_NE(problem_of(missing).find("no_such.frag"), std::string::npos);
}

TEST_F(PictureTest, EveryMethodDrawsTheCloth) {
  Design design = twill(4, 2, kRed, kRed);
  design.look.method = Method::kVrst03;  // so that its shadow maps and cube maps are made
  upload(design, square(100));
  for (const Method method : {Method::kFlat, Method::kVrst03, Method::kYarn, Method::kAuto}) {
    look.method = method;
    const Image image = draw(false);
    const Mean m = middle(image);
    EXPECT_GT(m.r, 2 * m.b) << static_cast<int>(method);
    EXPECT_GT(m.r, 0.1) << static_cast<int>(method);
    const FrameStats stats = renderer->measure();
    EXPECT_GT(stats.shaded_pixels, kSide * kSide / 8);
    EXPECT_GT(stats.texture_bytes, 0u);
  }
}

/// A 2/2 twill of threads that are all alike; more than 2^24 crossings, which an end and a pick of another colour keep
/// from repeating, if `large`.
Design plain_twill(bool large) {
  Design design = twill(4, 2, kRed, kBlue);
  const int threads = large ? 4100 : 8;
  const std::vector<Rgb> palette = design.draft.palette;
  design.draft = draft::blank_draft(threads, threads, 4, 4);
  design.draft.palette = palette;
  for (int i = 0; i < threads; ++i) {
    design.draft.threading.set(i, i % 4, true), design.draft.treadling.set(i, i % 4, true);
    design.draft.weft.color[static_cast<size_t>(i)] = 1;
  }
  for (int t = 0; t < 4; ++t)
    for (int s = 0; s < 4; ++s) design.draft.tieup.set(t, s, (t + s) % 4 < 2);
  if (large) design.draft.warp.color[0] = 1, design.draft.weft.color[0] = 0;
  for (design::Yarn& yarn : design.yarns) yarn.irregularity = yarn.unevenness = 0;
  return design;
}

TEST_F(PictureTest, DraftsOfAnySizeShowSingleThreads) {
  frame.samples = 8;
  Stages stages;
  const auto near_picture = [&](bool large) {
    stages.update(std::make_shared<const Design>(plain_twill(large)), Effort::kQuick);
    EXPECT_EQ(stages.packed().strips.empty(), !large);
    renderer->upload(stages.packed());
    const float repeat_mm = 4 * stages.packed().mean_spacing_mm;
    renderer->set_mesh(square(2.5f * repeat_mm, {500 * repeat_mm, 700 * repeat_mm}));
    return draw();
  };
  const Image small = near_picture(false);
  // The fibres of each thread differ. Without single threads the difference is 0.7.
  EXPECT_LT(relative_rms(small, near_picture(true)), 0.3);
  Design painted = plain_twill(true);
  painted.draft.threading.set(2000, 0, false), painted.draft.threading.set(2000, 2, true);
  const StageResult result = stages.update(std::make_shared<const Design>(painted), Effort::kQuick);
  EXPECT_FALSE(result.all_maps || result.patches.strips.empty());
  EXPECT_TRUE(stages.packed().strips == render_data::cell_strips(draft::drawdown(painted.draft)));
}

/// Threads of 0.4 mm every 2 mm.
Design open_cloth() {
  Design design = twill(2, 1, kRed, kRed);
  for (draft::Threads* threads : {&design.draft.warp, &design.draft.weft}) {
    std::ranges::fill(threads->spacing_mm, 2.0f);
    std::ranges::fill(threads->thickness_mm, 0.4f);
  }
  return design;
}

// A picture of minutes said nothing until it was done.
TEST_F(PictureTest, ASoftwareRendererTellsHowFarItIs) {
  upload(twill(4, 2, kRed, kBlue), square(100));
  frame.height = 200;
  const Image whole = draw(false);
  std::vector<float> told;
  frame.progress = [&told](float done) { told.push_back(done); };
  const Image banded = draw(false);
  frame.progress = {};
  EXPECT_EQ(banded.texels, whole.texels);
  if (!renderer->is_software()) GTEST_SKIP() << "a graphics card draws in one piece";
  ASSERT_GT(told.size(), 2u);
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_LT(told.front(), 0.05f);
  EXPECT_EQ(told.back(), 1);
}

TEST_F(PictureTest, ScaleKeepsThePicturesSize) {
  upload(twill(4, 2, kRed, kBlue), square(100));
  frame.render_scale = 0.5f;
  const Image image = draw(false);
  EXPECT_EQ(image.width, kSide);
  EXPECT_EQ(image.height, kSide);
  EXPECT_GT(middle(image).sum(), 0.1);
}

TEST_F(PictureTest, EachSideShowsItsFace) {
  upload(twill(8, 7, kRed, kBlue), square(100));  // warp-faced in front, weft-faced behind
  const Mean front = middle(draw());
  scene.view_azimuth = 180, scene.light_azimuth = 150;
  const Mean back = middle(draw());
  EXPECT_GT(front.r, 1.5 * front.b);
  EXPECT_GT(back.b, 1.5 * back.r);
  scene.view_azimuth = 0, scene.light_azimuth = -30;
  frame.front = Face::kBack;
  const Mean turned = middle(draw());
  EXPECT_GT(turned.b, 1.5 * turned.r);
}

// Drafts with too many crossings for the graphics card have no threads to draw one by one.
TEST_F(PictureTest, AClothWithoutThreadsOnTheCardIsDrawnFromItsMaps) {
  Stages stages;
  stages.update(std::make_shared<const Design>(twill(4, 2, kRed, kRed)));
  PackedCloth cloth = stages.packed();
  cloth.crossings.clear();
  renderer->upload(cloth);
  renderer->set_mesh(square(100));
  frame.yarns_per_pixel = 0.125f;
  for (const Method method : {Method::kAuto, Method::kYarn}) {
    look.method = method;
    const Mean m = middle(draw());
    EXPECT_GT(m.r, 2 * m.b) << static_cast<int>(method);
    EXPECT_GT(m.r, 0.1) << static_cast<int>(method);
  }
}

TEST_F(PictureTest, OnlyTheMethodsThatShowAreNeeded) {
  const PreparedMesh mesh = prepare_mesh(square(100));
  constexpr float kSpacing = 1, kYarnToRepeat = 1, kRepeatToCloth = 8;
  constexpr std::array<float, 3> edges{kYarnToRepeat, kYarnToRepeat, kRepeatToCloth};
  const auto needed = [&](float yarns) {
    const Camera camera = place_camera(scene, mesh.mesh, mesh.bounds, 64, 64, yarns, kSpacing);
    return method_weights(mesh, camera, 64, 64, kSpacing, edges).needed;
  };
  using Methods = std::array<bool, 4>;  // yarn, cell, repeat, cloth
  EXPECT_EQ(needed(0.25f), (Methods{true, false, false, false}));
  EXPECT_EQ(needed(0.85f), (Methods{true, false, true, false}));
  EXPECT_EQ(needed(3), (Methods{false, false, true, false}));
  EXPECT_EQ(needed(7), (Methods{false, false, true, true}));
  EXPECT_EQ(needed(32), (Methods{false, false, false, true}));
}

TEST_F(PictureTest, ZoomingOutKeepsTheLight) {
  // Tolerance 0.1: means of normals and of shadows are filtered apart, their correlation is not kept.
  constexpr double kTolerance = 0.1;
  for (const Method method : {Method::kFlat, Method::kYarn}) {
    look.method = method;
    upload(twill(4, 2, kWhite, kRed), square(3000));
    frame.yarns_per_pixel = 0.125f;
    const double near = middle(draw()).sum();
    for (const float footprint : {0.25f, 0.5f, 1.0f, 2.0f, 4.0f, 8.0f, 16.0f}) {
      frame.yarns_per_pixel = footprint;
      EXPECT_NEAR(middle(draw()).sum() / near, 1, kTolerance)
          << footprint << " yarns a pixel, method " << static_cast<int>(method);
      EXPECT_NEAR(renderer->measure().yarns_per_pixel, footprint, 0.02f * footprint);
    }
  }
}

TEST_F(PictureTest, ClothFarFromTheOriginOfItsUvKeepsItsColour) {
  const Design design = twill(4, 2, kWhite, kBlue);
  Stages stages;
  stages.update(std::make_shared<const Design>(design));
  renderer->upload(stages.packed());
  const float period = stages.packed().width_mm;
  renderer->set_mesh(square(60));
  const Mean here = middle(draw());
  renderer->set_mesh(square(60, {1e5f * period, 1e5f * period}));
  const Mean far = middle(draw());
  EXPECT_NEAR(far.r / here.r, 1, 0.02);
  EXPECT_NEAR(far.g / here.g, 1, 0.02);
  EXPECT_NEAR(far.b / here.b, 1, 0.02);
}

TEST_F(PictureTest, SceneLinearHoldsNoNanAtGrazingLightAndView) {
  Design design = twill(4, 1, kWhite, kBlue);
  frame.width = frame.height = 32, frame.samples = 4;
  for (const float width : {0.0f, 0.25f, 4.0f}) {
    design.yarns[0].lobes.along_width = design.yarns[0].lobes.across_width = width;
    upload(design, square(100));
    for (const float view : {0.0f, 80.0f, 89.9f, 100.0f}) {
      for (const float light : {0.0f, 89.9f, 179.0f}) {
        scene.view_azimuth = view, scene.light_azimuth = light;
        expect_finite(draw());
      }
    }
  }
}

/// A hanging fold: a tube on its end, a little aslant, facing outwards.
Mesh fold(float radius_mm, float height_mm, uint32_t sides) {
  Mesh mesh;
  for (int i = 0; i <= static_cast<int>(sides); ++i) {
    const float turn = 6.2831853f * static_cast<float>(i) / static_cast<float>(sides), c = std::cos(turn),
                s = std::sin(turn);
    for (const float y : {0.0f, height_mm}) {
      mesh.position_mm.push_back({radius_mm * s + 0.1f * y, y, radius_mm * c});
      mesh.normal.push_back({s, 0, c});
      mesh.tangent.push_back({c, 0, -s});
      mesh.uv_mm.push_back({radius_mm * turn, y});
    }
  }
  for (uint32_t k = 0; k < 2 * sides; k += 2) mesh.index.insert(mesh.index.end(), {k, k + 2, k + 3, k, k + 3, k + 1});
  return mesh;
}

// Only a thin strip of a fold shines like cloth seen edge-on; over whole pixels it drew bright dashes along
// silhouettes.
TEST_F(PictureTest, TheRimOfAFoldIsThatOfItsOwnFinerPicture) {
  const wif::WifRead satin =
      wif::read_wif(base::read_file(presets_dir() + "/cloths/polyester_satin_charmeuse.wif").value_or(""));
  ASSERT_TRUE(satin.file);
  upload(satin.file->design, fold(4, 100, 64));
  renderer->set_lights(load_light_rig("overcast").value());
  look.method = Method::kCloth;
  frame.transparent = true;
  scene.light_strength = 0;
  constexpr int kFiner = 16;
  Image mean = draw();
  const Image coarse = mean;
  frame.width = frame.height = kSide * kFiner;
  const Image fine = draw();
  renderer->set_lights(load_light_rig("studio").value());
  for (size_t i = 0; i < mean.texels.size(); ++i) {
    const size_t x = i / 4 % kSide * kFiner, y = i / 4 / kSide * kFiner;
    float sum = 0;
    for (size_t k = 0; k < kFiner * kFiner; ++k)
      sum += fine.texels[4 * ((y + k / kFiner) * kSide * kFiner + x + k % kFiner) + i % 4];
    mean.texels[i] = sum / (kFiner * kFiner);
  }
  EXPECT_LT(relative_rms(mean, coarse), 0.15);  // 0.24 then, 0.10 now
}

// Lines ran across curtains of gauze, where one band ends and the next begins.
TEST_F(PictureTest, BandsOfAnOpenClothHaveNoSeams) {
  upload(open_cloth(), fold(20, 100, 64));
  look.method = Method::kCloth;
  frame.height = 200;
  frame.transparent = true;
  const Image whole = draw(false);
  frame.progress = [](float) {};
  const Image banded = draw(false);
  frame.progress = {};
  EXPECT_EQ(banded.texels, whole.texels);
}

// Texels of the shadow's map are steps in a shadow's edge, and a surface lit aslant draws them out to teeth.
TEST_F(PictureTest, AShadowOnClothLitAslantHasAStraightEdge) {
  upload(twill(4, 2, kWhite, kWhite), walled_square());
  look.method = Method::kFlat;
  scene.sky_strength = 0;
  scene.light_azimuth = 80, scene.light_elevation = 0;
  frame.width = frame.height = 512;
  const Image image = draw();
  std::vector<double> starts;
  for (int y = 160; y < 352; ++y) starts.push_back(shadow_starts(image, y));
  EXPECT_NEAR(std::abs(starts.back() - starts.front()), 0.02 * 191, 3) << "this is not the wall's shadow";
  EXPECT_LT(roughness(starts), 0.6);  // 0.94 pixels with a map half as fine
}

// The shadow's filter reaches past its texels: an inclined plane shadowed itself in stripes (visible on a table's
// foot).
TEST_F(PictureTest, APlaneDoesNotShadeItself) {
  upload(twill(4, 2, kWhite, kWhite), square(100));
  look.method = Method::kFlat;
  scene.sky_strength = 0;
  for (const float azimuth : {-20.0f, -50.0f, -70.0f, -80.0f}) {
    for (const float elevation : {5.0f, 38.0f, 60.0f}) {
      scene.light_azimuth = azimuth, scene.light_elevation = elevation;
      const Image image = draw();
      float low = 1e9f, high = 0;
      for (int y = kSide / 4; y < kSide * 3 / 4; ++y) {
        for (int x = kSide / 4; x < kSide * 3 / 4; ++x) {
          const float v = image.texels[(static_cast<size_t>(y) * kSide + static_cast<size_t>(x)) * 4 + 1];
          low = std::min(low, v), high = std::max(high, v);
        }
      }
      EXPECT_GT(low, 0.98f * high) << azimuth << ' ' << elevation;
    }
  }
}

// With pinholes, what lies behind the cloth is drawn first. Denim has none: its far side was shaded for nothing.
TEST_F(PictureTest, ThreadsThatTouchHideWhatIsBehindThem) {
  const wif::WifRead denim = wif::read_wif(base::read_file(presets_dir() + "/cloths/denim.wif").value_or(""));
  ASSERT_TRUE(denim.file);
  upload(denim.file->design, fold(80, 100, 64));
  frame.transparent = true;
  look.method = Method::kYarn;
  const Image near = draw();
  const double shaded = renderer->measure().shaded_pixels;
  look.method = Method::kFlat;
  EXPECT_EQ(middle_alpha(near), middle_alpha(draw()));
  EXPECT_LT(shaded, 1.1 * renderer->measure().shaded_pixels);
}

TEST_F(PictureTest, GapsLetTheBackgroundThrough) {
  upload(open_cloth(), square(100));
  frame.transparent = true;
  // Threads of 0.4 mm, pressed a little flat, every 2 mm both ways.
  constexpr double kWidth = 0.4472, kCovered = 1 - (1 - kWidth / 2) * (1 - kWidth / 2);
  EXPECT_NEAR(middle_alpha(draw()), kCovered, 0.03);
}

TEST_F(PictureTest, PatchesGiveThePictureOfAWholeUpload) {
  const Design before = twill(8, 4, kRed, kBlue);
  Design after = before;
  after.draft.liftplan.set(3, 2, !after.draft.liftplan.get(3, 2));
  Stages stages;
  stages.update(std::make_shared<const Design>(before));
  renderer->upload(stages.packed());
  renderer->set_mesh(square(30));
  const StageResult edit = stages.update(std::make_shared<const Design>(after));
  ASSERT_FALSE(edit.all_maps);
  ASSERT_FALSE(edit.patches.empty());
  renderer->upload(edit.patches);
  renderer->upload_lobes(*edit.lobes);
  const Image patched = draw(false);
  Stages anew;
  anew.update(std::make_shared<const Design>(after));
  renderer->upload(anew.packed());
  const Image whole = draw(false);
  EXPECT_EQ(patched.texels, whole.texels);
}

/// The shaders, one of them spoilt, for as long as it lives.
class SpoiltShader {
 public:
  explicit SpoiltShader(const std::string& name) : folder_(testing::TempDir() + "spoilt_shaders") {
    std::filesystem::remove_all(folder_);
    std::filesystem::copy(shaders_dir(), folder_, std::filesystem::copy_options::recursive);
    std::ofstream(folder_ + "/" + name, std::ios::app) << "\nvec3 not_a_formula = no_such_thing;\n";
    setenv("WEFTLIGHT_SHADERS", folder_.c_str(), 1);
  }
  ~SpoiltShader() {
    unsetenv("WEFTLIGHT_SHADERS");
    std::filesystem::remove_all(folder_);
  }

 private:
  std::string folder_;
};

// Most programs are compiled when first needed. One that failed then left no cloth and no message.
TEST_F(PictureTest, AShaderThatFailsLateIsTold) {
  const auto made = Renderer::create();
  ASSERT_TRUE(made) << problem_of(made);
  const std::unique_ptr<Renderer>& fresh = *made;
  Stages stages;
  stages.update(std::make_shared<const Design>(twill(4, 2, kRed, kRed)));
  fresh->upload(stages.packed());
  fresh->set_mesh(square(30));
  look.method = Method::kFlat;
  {
    const SpoiltShader spoilt("method_flat.glsl");
    const std::string problem = problem_of(fresh->draw(scene, look, frame).cloth);
    EXPECT_NE(problem.find("flat: cloth.frag does not compile"), std::string::npos) << problem;
    EXPECT_NE(problem.find("no_such_thing"), std::string::npos) << problem;
  }
  EXPECT_FALSE(fresh->draw(scene, look, frame).cloth) << "nor is it forgotten";
  look.method = Method::kCell;
  EXPECT_EQ(problem_of(fresh->draw(scene, look, frame).cloth), "");
  EXPECT_GT(middle(fresh->read_back(true)).r, 0.01);
}

/// All that the context holds: textures, buffers, programs and the like. Names are given out from the lowest on.
size_t objects_of_the_context() {
  constexpr GLuint kNames = 4096;
  size_t count = 0;
  for (GLuint name = 1; name < kNames; ++name)
    for (const GLboolean there : {glIsTexture(name), glIsBuffer(name), glIsFramebuffer(name), glIsRenderbuffer(name),
                                  glIsVertexArray(name), glIsQuery(name), glIsProgram(name), glIsShader(name)})
      count += there == GL_TRUE;
  return count;
}

TEST_F(PictureTest, DaysOfDraftsDrapesAndLightsLeaveNothingOnTheCard) {
  constexpr int kDays = 5, kFirst = 1;  // programs are made when they are first needed, in two lights
  size_t after_first = 0;
  for (int day = 0; day < kDays; ++day) {
    const Design before = twill(day % 2 == 0 ? 4 : 8, 2, kRed, kBlue);
    Design after = before;
    after.draft.liftplan.set(1, 1, !after.draft.liftplan.get(1, 1));
    Stages stages({4, 64});
    stages.update(std::make_shared<const Design>(before), Effort::kQuick);
    renderer->upload(stages.packed());
    renderer->set_mesh(square(40 + static_cast<float>(10 * day)));
    renderer->set_lights(load_light_rig(day % 2 == 0 ? "studio" : "window").value());
    for (const Method method : {Method::kAuto, Method::kCloth, Method::kFlat}) {
      look.method = method;
      frame.width = 16 + 8 * (day % 3);
      draw();
    }
    const StageResult painted = stages.update(std::make_shared<const Design>(after), Effort::kQuick);
    painted.all_maps ? renderer->upload(stages.packed()) : renderer->upload(painted.patches);
    draw(false);
    if (day == kFirst) after_first = objects_of_the_context();
  }
  EXPECT_GT(after_first, 20u);
  EXPECT_LE(objects_of_the_context(), after_first);
}

TEST_F(PictureTest, TheLastSubmittedDesignIsDrawn) {
  Pipeline pipeline;
  Design design = twill(4, 2, kRed, kRed);
  design.scene.mesh = "";
  pipeline.submit(std::make_shared<const Design>(design));
  design.draft.palette = {kBlue, kBlue};
  pipeline.submit(std::make_shared<const Design>(design));
  pipeline.finish(*renderer);
  renderer->set_mesh(square(100));
  const Mean m = middle(draw());
  EXPECT_GT(m.b, 2 * m.r);
  EXPECT_FALSE(pipeline.busy());
}

// A quick update keeps the far field of the design before it, which is that of another cloth after a change of tabs.
TEST_F(PictureTest, TheFirstPictureOfAnotherDraftHasNothingOfTheLastOnesCloth) {
  look.method = Method::kCloth;
  Design red = twill(4, 2, kRed, kRed), blue = twill(4, 2, kBlue, kBlue);
  red.scene.mesh = blue.scene.mesh = "";
  Pipeline pipeline;
  pipeline.submit(std::make_shared<const Design>(red), 1);
  pipeline.finish(*renderer);
  const auto shown = std::make_shared<const Design>(blue);
  pipeline.submit(shown, 2);
  while (pipeline.uploaded() != shown) {
    pipeline.poll(*renderer);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  renderer->set_mesh(square(100));
  const Mean first = middle(draw());
  pipeline.finish(*renderer);
  renderer->set_mesh(square(100));
  const Mean finished = middle(draw());
  EXPECT_NEAR(first.b, finished.b, 0.1 * finished.b);
  EXPECT_NEAR(first.r, finished.r, 0.1 * finished.b);
}

// The window once took its first picture for the final one while better maps were ready.
TEST_F(PictureTest, ThePipelineIsBusyUntilWhatItMadeIsTakenUp) {
  Pipeline pipeline;
  Design design = twill(4, 2, kRed, kRed);
  design.scene.mesh = "";
  pipeline.submit(std::make_shared<const Design>(design));
  pipeline.wait();
  EXPECT_TRUE(pipeline.busy()) << "computed, but not yet on the graphics card";
  EXPECT_TRUE(pipeline.poll(*renderer));
  EXPECT_FALSE(pipeline.busy());
  EXPECT_FALSE(pipeline.poll(*renderer));
}

TEST_F(PictureTest, AMeshThatIsNotThereIsAProblemAndTheClothIsDrawnAllTheSame) {
  Pipeline pipeline;
  Design design = twill(4, 2, kRed, kRed);
  design.scene.mesh = "no/such/file.glb";
  pipeline.submit(std::make_shared<const Design>(design));
  EXPECT_NE(problem_of(pipeline.finish(*renderer)).find("no/such/file.glb"), std::string::npos);
}

}  // namespace
}  // namespace weftlight::gl
