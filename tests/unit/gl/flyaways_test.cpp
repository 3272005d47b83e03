#include "render_data/flyaways.h"

#include <algorithm>
#include <numeric>

#include "picture.h"

namespace weftlight::gl {

using design::Design, design::Method;
using draft::Face, draft::Rgb;
using drape::Mesh, drape::Vec3;
using files::Image;
using render_data::Flyaway, render_data::FlyawayGrowth, render_data::FlyawayView, render_data::Hem,
    render_data::PreparedMesh, render_data::flyaway_growth, render_data::hems_of, render_data::kMaxFlyaways,
    render_data::scatter_flyaways, render_data::square, render_data::twill;

namespace {

constexpr Rgb kGrey{0.6f, 0.55f, 0.5f};

Design cloth_of(float fuzz, float fuzz_width = 0.65f) {
  Design design = twill(4, 2, kGrey, kGrey);
  design.yarns[0].lobes.fuzz = fuzz;
  design.yarns[0].lobes.fuzz_width = fuzz_width;
  return design;
}

/// A tube along y whose seam has its vertices twice.
Mesh tube(float radius_mm, float height_mm) {
  constexpr int kAround = 96, kUp = 12;
  constexpr float kTwoPi = 6.2831853f;
  Mesh mesh;
  for (int y = 0; y <= kUp; ++y) {
    for (int x = 0; x <= kAround; ++x) {
      const float a = kTwoPi * static_cast<float>(x % kAround) / kAround, v = height_mm * static_cast<float>(y) / kUp;
      mesh.position_mm.push_back({radius_mm * std::sin(a), v, radius_mm * std::cos(a)});
      mesh.normal.push_back({std::sin(a), 0, std::cos(a)});
      mesh.tangent.push_back({std::cos(a), 0, -std::sin(a)});
      mesh.uv_mm.push_back({radius_mm * kTwoPi * static_cast<float>(x) / kAround, v});
    }
  }
  for (int y = 0; y < kUp; ++y) {
    for (int x = 0; x < kAround; ++x) {
      const uint32_t a = static_cast<uint32_t>(y * (kAround + 1) + x), b = a + kAround + 1;
      mesh.index.insert(mesh.index.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  }
  return mesh;
}

double alpha_sum(const Image& image) {
  double sum = 0;
  for (size_t i = 3; i < image.texels.size(); i += 4) sum += static_cast<double>(image.texels[i]);
  return sum;
}

class FlyawaysTest : public PictureTest {
 protected:
  void SetUp() override {
    PictureTest::SetUp();
    frame.transparent = true;
    frame.width = frame.height = 256;
    frame.yarns_per_pixel = 0.25f;
    look.method = Method::kCloth;  // the test is about the coverage of fibres, not the shading of threads
  }
  Image picture(const Design& design) {
    upload(design, tube(8, 60));
    return draw();
  }
};

TEST_F(FlyawaysTest, WoolStandsOffItsSilhouetteAndFilamentDoesNot) {
  const Image bare = picture(cloth_of(0)), wool = picture(cloth_of(0.35f));
  EXPECT_GT(renderer->measure().flyaways, 100u);
  const Image filament = picture(cloth_of(0.02f));
  EXPECT_EQ(renderer->measure().flyaways, 0u);
  int beyond = 0;
  for (size_t i = 3; i < bare.texels.size(); i += 4) {
    beyond += bare.texels[i] == 0 && wool.texels[i] > 0.02f;
    EXPECT_EQ(filament.texels[i], bare.texels[i]);
  }
  EXPECT_GT(beyond, 256);  // the tube has two sides, 256 pixels high
}

TEST_F(FlyawaysTest, ZoomingInKeepsWhatTheyCover) {
  // The same millimetres with ever more pixels, from fibres of four pixels to fifteen. Tolerance 12 % a step: bends are
  // shortened at a pixel's size, and fibres at the very edge are widened under the cloth.
  constexpr double kTolerance = 0.12;
  std::array<double, 3> covered{};
  for (const float fuzz : {0.0f, 0.35f}) {
    upload(cloth_of(fuzz), tube(8, 60));
    for (size_t zoom = 0; zoom < covered.size(); ++zoom) {
      frame.width = frame.height = 192 << zoom;
      frame.yarns_per_pixel = 0.8f / 3 / static_cast<float>(1 << zoom);
      const double cover = alpha_sum(draw()) / std::pow(4.0, static_cast<double>(zoom));
      covered[zoom] = cover - covered[zoom];
    }
  }
  for (size_t zoom = 0; zoom + 1 < covered.size(); ++zoom) {
    EXPECT_GT(covered[zoom], 0);
    EXPECT_NEAR(covered[zoom] / covered[zoom + 1], 1, kTolerance) << zoom;
  }
}

TEST_F(FlyawaysTest, ThePictureIsOpaqueAtMostAndFinite) {
  for (const float width : {0.05f, 1.0f}) {
    upload(cloth_of(1, width), tube(8, 60));
    for (const float yarns : {0.01f, 0.3f, 3.0f}) {
      frame.yarns_per_pixel = yarns;
      scene.view_elevation = yarns > 1 ? 89.9f : 0.0f;
      const Image image = draw();
      for (size_t i = 0; i < image.texels.size(); ++i) {
        ASSERT_TRUE(std::isfinite(image.texels[i]));
        ASSERT_GE(image.texels[i], 0.0f);
      }
      for (size_t i = 3; i < image.texels.size(); i += 4) {
        ASSERT_LE(image.texels[i], 1.0f + 1e-3f);  // of a half float
      }
    }
  }
}

TEST_F(FlyawaysTest, TheSameViewGivesTheSamePicture) {
  frame.width = frame.height = 128;
  const Image first = picture(cloth_of(0.35f));
  scene.view_azimuth = 40;
  draw();
  scene.view_azimuth = 0;
  EXPECT_EQ(draw().texels, first.texels);
}

TEST_F(FlyawaysTest, MovingViewsAndTheBaselinesHaveNone) {
  upload(cloth_of(0.35f), tube(8, 60));
  look.method = Method::kFlat;
  draw(false);
  EXPECT_EQ(renderer->measure().flyaways, 0u);
  look.method = Method::kAuto;
  frame.render_scale = 0.5f;
  draw(false);
  EXPECT_EQ(renderer->measure().flyaways, 0u);
}

TEST(Hems, AreWhereTheClothEndsAndNotAtItsSeams) {
  const Mesh flat = square(80), round = tube(8, 60);
  const std::vector<Hem> around = hems_of(flat, flat.index);
  EXPECT_EQ(around.size(), 32u);
  for (const Hem& hem : around) {
    const Vec3& p = flat.position_mm[hem.from];
    EXPECT_GT(glm::dot(hem.outward, glm::vec3(p[0], p[1] - 40, p[2])), 0);
    EXPECT_NEAR(glm::length(hem.outward), 1, 1e-5);
  }
  EXPECT_EQ(hems_of(round, round.index).size(), 2u * 96);
}

/// A tube 300 mm high from 1 m away, `pixel_mm` at the tube.
std::vector<Flyaway> scattered(const FlyawayGrowth& growth, float pixel_mm) {
  PreparedMesh prepared;
  prepared.mesh = tube(40, 300);
  prepared.fine = prepared.mesh.index;
  FlyawayView view;
  view.eye = {0, 150, 1000};
  view.width = view.height = 1000;
  const float scale = 2 / (view.height * pixel_mm / 1000);
  view.world_to_clip = glm::mat4(0);
  view.world_to_clip[0][0] = view.world_to_clip[1][1] = scale, view.world_to_clip[3][1] = -150 * scale;
  view.world_to_clip[2][2] = view.world_to_clip[2][3] = -1;
  view.world_to_clip[3][2] = view.world_to_clip[3][3] = 1000;
  return scatter_flyaways(prepared, {}, {}, growth, view);
}

constexpr FlyawayGrowth kWool{{20, 0}, {2.4f, 0}, 0.2f};

double fibres(const std::vector<Flyaway>& flyaways) {
  return std::accumulate(flyaways.begin(), flyaways.end(), 0.0,
                         [](double sum, const Flyaway& h) { return sum + static_cast<double>(h.stands_for); });
}

TEST(Flyaways, StandAtTheEdgeAndStandForAsManyFromAfar) {
  const std::vector<Flyaway> near = scattered(kWool, 0.3f), far = scattered(kWool, 0.6f);
  ASSERT_GT(far.size(), 100u);
  EXPECT_GT(near.size(), far.size());
  EXPECT_NEAR(fibres(near) / fibres(far), 1, 0.1);
  float farthest = 0;
  for (const Flyaway& fibre : near) {
    ASSERT_EQ(fibre.side, 1);
    farthest =
        std::max(farthest, std::abs(glm::dot(fibre.normal, glm::normalize(glm::vec3(0, 150, 1000) - fibre.root))));
  }
  EXPECT_LT(farthest, 0.85f);  // sqrt(2 h / R) of the longest fibres, 4.6 means, and some for the mesh
}

TEST(Flyaways, FadeOutTogetherWhereTheyWouldBeDots) {
  const std::vector<Flyaway> near = scattered(kWool, 0.6f), far = scattered(kWool, 0.96f);  // 4 and 2.5 pixels long
  ASSERT_GT(far.size(), 0.4 * static_cast<double>(near.size()));
  EXPECT_NEAR(fibres(far) / fibres(near), 0.4, 0.05);  // a linear fade from 4 to 1.5
  EXPECT_TRUE(scattered(kWool, 2.0f).empty());
}

TEST(Flyaways, AreNoMoreThanCanBeSeenOrDrawn) {
  EXPECT_TRUE(scattered({{20, 20}, {0.6f, 0.6f}, 0.2f}, 2.0f).empty());
  EXPECT_TRUE(scattered({}, 0.1f).empty());
  const std::vector<Flyaway> many = scattered({{5000, 5000}, {3, 3}, 0.2f}, 0.3f);
  EXPECT_LT(static_cast<float>(many.size()), 1.2f * kMaxFlyaways);
  EXPECT_GT(static_cast<float>(many.size()), 0.2f * kMaxFlyaways);
}

TEST(Flyaways, GrowByTheFuzzThatShows) {
  interop::ClothData cloth{};
  for (interop::SystemData& s : cloth.systems) s.coverage = 0.5f, s.yarn.fuzz_depth = 0.4f, s.yarn.fuzz = 0.02f;
  EXPECT_EQ(flyaway_growth(cloth, Face::kFront).per_mm2[0], 0);
  cloth.systems[1].yarn.fuzz = 0.35f;  // the front's weft
  const FlyawayGrowth front = flyaway_growth(cloth, Face::kFront), turned = flyaway_growth(cloth, Face::kBack);
  EXPECT_GT(front.per_mm2[0], 0);
  EXPECT_EQ(front.per_mm2[1], 0);
  EXPECT_EQ(turned.per_mm2[1], front.per_mm2[0]);
  cloth.systems[0].yarn.fuzz = 0.35f;
  EXPECT_FLOAT_EQ(flyaway_growth(cloth, Face::kFront).per_mm2[0], 2 * front.per_mm2[0]);
}

}  // namespace
}  // namespace weftlight::gl
