// Threads as the shaders evaluate them (shaders/threads.glsl) against the traced tubes: same thread, position, normal
// and shadow.

#include "cloth/thread_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "reference/tubes.h"

namespace weftlight::reference {

using base::problem_of;
using cloth::Cloth, cloth::Period, cloth::ThreadScene, cloth::lay_out;
using design::Design;
using draft::BitMatrix, draft::Face, draft::Threads, draft::blank_draft, draft::kFromYarn;

namespace {

/// Warp over `up`, under `down`, a step aside at every pick.
Cloth twill(int up, int down) {
  Design design;
  const int count = 4 * (up + down);
  design.draft = blank_draft(count, count, up + down, up + down);
  BitMatrix cells(count, count);
  for (int p = 0; p < count; ++p)
    for (int e = 0; e < count; ++e) cells.set(p, e, (e + p) % (up + down) < up);
  return lay_out(design, cells, Face::kFront, Period::kWholeDraft);
}

glm::vec3 direction(float tilt_deg, float azimuth_deg) {
  const float t = glm::radians(tilt_deg), a = glm::radians(azimuth_deg);
  return {std::sin(t) * std::cos(a), std::sin(t) * std::sin(a), std::cos(t)};
}

/// A 2/2 twill with three ends seven times as thick as the rest.
Cloth with_thick_ends() {
  Design design;
  design.draft = blank_draft(16, 16, 4, 4);
  BitMatrix cells(16, 16);
  for (int p = 0; p < 16; ++p)
    for (int e = 0; e < 16; ++e) cells.set(p, e, (e + p) % 4 < 2);
  design.yarns[0].diameter_mm = 0.25f;
  design.draft.warp.thickness_mm.assign(16, kFromYarn);
  design.draft.warp.spacing_mm.assign(16, kFromYarn);
  for (size_t e = 3; e < 6; ++e) design.draft.warp.thickness_mm[e] = 1.8f, design.draft.warp.spacing_mm[e] = 2.5f;
  return lay_out(design, cells, Face::kFront, Period::kWholeDraft);
}

/// Two layers of plain weave that change places every 16 threads.
Cloth pockets() {
  Design design;
  design.draft = blank_draft(32, 32, 4, 4);
  BitMatrix cells(32, 32);
  for (int p = 0; p < 32; ++p) {
    for (int e = 0; e < 32; ++e) {
      const bool first = e % 2 == 0, above = (e / 16 + p / 16) % 2 == 0;
      cells.set(p, e, first == (p % 2 == 0) ? (e / 2 + p / 2) % 2 == 0 : first == above);
    }
  }
  return lay_out(design, cells, Face::kFront, Period::kWholeDraft);
}

/// Plain weave of uneven yarn, with gaps between the threads.
Cloth slubs() {
  Design design;
  design.draft = blank_draft(40, 40, 2, 2);
  BitMatrix cells(40, 40);
  for (int p = 0; p < 40; ++p)
    for (int e = 0; e < 40; ++e) cells.set(p, e, (e + p) % 2 == 0);
  design.yarns[0].diameter_mm = 0.25f, design.yarns[0].unevenness = 36;
  for (Threads* t : {&design.draft.warp, &design.draft.weft})
    t->thickness_mm.assign(40, kFromYarn), t->spacing_mm.assign(40, 0.5f);
  return lay_out(design, cells, Face::kFront, Period::kWholeDraft);
}

/// Squares of plain weave and of floats in an open sett, which washing bends into ovals.
Cloth ovals() {
  Design design;
  design.draft = blank_draft(32, 32, 4, 4);
  BitMatrix cells(32, 32);
  for (int p = 0; p < 32; ++p) {
    for (int e = 0; e < 32; ++e) {
      const bool plain = (e / 4 + p / 4) % 2 == 0, warp = (e / 8 + p / 8) % 2 == 0;
      cells.set(p, e, plain ? (e + p) % 2 == 0 : warp);
    }
  }
  design.yarns[0].diameter_mm = 0.3f;
  for (Threads* t : {&design.draft.warp, &design.draft.weft})
    t->thickness_mm.assign(32, kFromYarn), t->spacing_mm.assign(32, 0.5f);
  return lay_out(design, cells, Face::kFront, Period::kWholeDraft);
}

/// Ribs: a fine flat warp, close over thick round picks.
Cloth cords() {
  Design design;
  design.draft = blank_draft(24, 4, 2, 2);
  BitMatrix cells(4, 24);
  for (int p = 0; p < 4; ++p)
    for (int e = 0; e < 24; ++e) cells.set(p, e, (e + p) % 2 == 0);
  design.yarns[0].flattening = 0.5f;
  design.draft.warp.thickness_mm.assign(24, 0.13f), design.draft.warp.spacing_mm.assign(24, 0.15f);
  design.draft.weft.thickness_mm.assign(4, 1.5f), design.draft.weft.spacing_mm.assign(4, 2.1f);
  return lay_out(design, cells, Face::kFront, Period::kWholeDraft);
}

/// A warp satin of ends that are wider than their room.
Cloth jammed() {
  Design design;
  design.draft = blank_draft(16, 16, 8, 8);
  BitMatrix cells(16, 16);
  for (int p = 0; p < 16; ++p)
    for (int e = 0; e < 16; ++e) cells.set(p, e, (e * 3 + p) % 8 != 0);
  design.draft.warp.thickness_mm.assign(16, 0.4f), design.draft.warp.spacing_mm.assign(16, 0.36f);
  design.draft.weft.thickness_mm.assign(16, 0.4f), design.draft.weft.spacing_mm.assign(16, 0.6f);
  return lay_out(design, cells, Face::kFront, Period::kWholeDraft);
}

class Threads : public testing::TestWithParam<int> {
 protected:
  /// Built once for all tests of a weave: it is most of their time.
  struct Woven {
    Cloth cloth;
    std::unique_ptr<TubeScene> tubes;
  };
  static Cloth weave(int which) {
    return which == kThick     ? with_thick_ends()
           : which == kPockets ? pockets()
           : which == kSlubs   ? slubs()
           : which == kCords   ? cords()
           : which == kOvals   ? ovals()
           : which == kJammed  ? jammed()
                               : twill(which, 3 - which / 2);
  }
  void SetUp() override {
    Woven& woven = all[GetParam()];
    if (woven.tubes) return;
    woven.cloth = weave(GetParam());
    auto tubes = TubeScene::build(woven.cloth, {});
    ASSERT_TRUE(tubes) << problem_of(tubes);
    woven.tubes = std::move(*tubes);
  }
  static void TearDownTestSuite() { all.clear(); }
  static constexpr int kThick = 4, kPockets = 5, kSlubs = 6, kCords = 7, kOvals = 8, kJammed = 9;
  static inline std::map<int, Woven> all;
  const Cloth& cloth() const { return all[GetParam()].cloth; }
  const TubeScene& tubes() const { return *all[GetParam()].tubes; }
};

TEST_P(Threads, RaysMeetTheSameThreadsAsTheTubes) {
  ThreadScene threads(cloth());
  const auto grid = threads.grid();
  const glm::vec3 light = direction(40, 70);
  for (const float tilt : {0.0f, 8.0f, 40.0f, 80.0f}) {
    const glm::vec3 v = direction(tilt, 25);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0, 1);
    constexpr int kRays = 4000;
    int other = 0, other_shadow = 0, lit = 0;
    double apart = 0, turned = 0;
    for (int i = 0; i < kRays; ++i) {
      const glm::vec2 at = glm::vec2(unit(random), unit(random)) * grid.period;
      TubeHit hit;
      const bool met = tubes().intersect(glm::vec3(at, 0) + v * (4 * grid.top / v.z), -v, 0, hit);
      const auto found = threads.first_thread(grid, at, v, 48);
      if (met != (found.system >= 0) ||
          (met && (found.system != static_cast<int>(hit.system) || found.strand.thread != hit.thread))) {
        ++other;
        continue;
      }
      if (!met) continue;
      const auto point = threads.thread_point(found.system, found.strand, found.at);
      apart += static_cast<double>(std::abs(found.at.z - hit.position.z));
      turned += static_cast<double>(std::acos(std::min(1.0f, glm::dot(point.normal, hit.normal))));
      if (glm::dot(hit.normal, light) <= 0) continue;
      ++lit;
      if (tubes().occluded(hit.position + hit.normal * (2e-3f * grid.top), light, 0) !=
          threads.threads_block(grid, found.at, light, 24, found.system, found.strand.thread))
        ++other_shadow;
    }
    // For plain weave of touching threads, and for steep threads where layers change places, the approximate distance
    // reports a grazing ray as a hit a little early.
    const bool sharp = GetParam() == kThick || GetParam() == kCords;  // fine threads bend sharply about thick ones
    EXPECT_LT(other, (GetParam() == kPockets ? tilt > 60 ? 0.25 : 0.04 : sharp ? 0.04 : 0.03) * kRays) << tilt;
    EXPECT_LT(apart / kRays, (GetParam() == kPockets ? 0.012 : 0.006) * static_cast<double>(grid.top)) << tilt;
    EXPECT_LT(turned / kRays, sharp || GetParam() == kPockets ? 0.05 : GetParam() == kJammed ? 0.02 : 0.01) << tilt;
    EXPECT_LT(other_shadow, 0.03 * lit) << tilt;
  }
}

TEST_P(Threads, LightFromBelowIsStoppedByTheThreadsBelow) {
  ThreadScene threads(cloth());
  const auto grid = threads.grid();
  const glm::vec3 light = -direction(30, 10);
  int other = 0;
  constexpr int kPoints = 1000;
  for (int i = 0; i < kPoints; ++i) {
    const glm::vec2 at = glm::fract(glm::vec2(0.7549f, 0.5698f) * static_cast<float>(i)) * grid.period;
    const glm::vec3 from(at, 0.98f * grid.top);
    if (tubes().occluded(from, light, 0) != threads.threads_block(grid, from, light, 24, -1, 0)) ++other;
  }
  EXPECT_LT(other, 0.03 * kPoints);
}

TEST_P(Threads, TheTileHasNoSeam) {
  // Sections lean across the tile's border, so both sides must contain them.
  ThreadScene threads(cloth());
  const auto grid = threads.grid();
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int i = 0; i < 2000; ++i) {
    glm::vec2 at = glm::vec2(unit(random), unit(random)) * grid.period;
    at[i % 2] = (unit(random) - 0.5f) * 0.2f * grid.spacing;
    TubeHit hit;
    if (!tubes().intersect(glm::vec3(at, 2 * grid.top), {0, 0, -1}, 0, hit)) continue;
    if (hit.normal.z < 0.15f) continue;  // at a rim one may meet the thread that the other just misses
    EXPECT_NEAR(threads.first_thread(grid, at, {0, 0, 1}, 48).at.z, hit.position.z,
                (GetParam() == kPockets ? 0.2f : 0.1f) * grid.top)
        << at.x << ' ' << at.y;
  }
}

TEST_P(Threads, TheBackIsTheFrontTurnedOver) {
  Cloth back = cloth();
  for (int p = 0; p < cloth().up.rows(); ++p)
    for (int e = 0; e < cloth().up.cols(); ++e) back.up.set(p, e, !cloth().up.get(p, e));
  for (float& level : back.warp_level_mm) level = -level;
  for (float& level : back.weft_level_mm) level = -level;
  ThreadScene turned(cloth(), Face::kBack), complement(back);
  const auto a = turned.grid(), b = complement.grid();
  for (int i = 0; i < 500; ++i) {
    const glm::vec2 at = glm::fract(glm::vec2(0.7549f, 0.5698f) * static_cast<float>(i)) * a.period;
    const auto front = turned.first_thread(a, at, {0, 0, 1}, 0), other = complement.first_thread(b, at, {0, 0, 1}, 0);
    ASSERT_EQ(front.system, other.system);
    if (front.system >= 0) {
      EXPECT_NEAR(front.at.z, other.at.z, 1e-5f);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Weaves, Threads, testing::Values(1, 2, 3, 4, 5, 6, 7, 8, 9));

}  // namespace
}  // namespace weftlight::reference
