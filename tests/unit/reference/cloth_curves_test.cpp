// The threads of a patch as curves: what is in the patch, over and under, plies twisted about each other, and the
// fibres.

#include "reference/cloth_curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "design/yarn_presets.h"
#include "reference/fibre_scene.h"
#include "reference/thread_paths.h"

namespace weftlight::reference {
namespace {

using cloth::CurveGroup, cloth::Curves;
using design::Twist, design::Yarn, design::yarn_presets;

constexpr float kSpacing = 0.6f;
constexpr int kThreads = 4;

/// A plain weave whose ends and picks are of two yarns.
Cloth two_yarns(int plies = 1) {
  Cloth cloth;
  cloth.yarns = {yarn_presets()[0], yarn_presets()[3]};
  for (Yarn& yarn : cloth.yarns) yarn.plies = plies, yarn.twist = Twist::kZ, yarn.turns_per_m = 500;
  for (int i = 0; i < kThreads; ++i)
    cloth.ends.push_back(
        {(static_cast<float>(i) + 0.5f) * kSpacing, kSpacing, 0.5f, 0.4f, {0.5f, 0.2f, 0.1f}, 0, 0, 0.45f});
  cloth.picks = cloth.ends;
  for (cloth::ThreadBody& pick : cloth.picks) pick.yarn = 1, pick.colour = {0.1f, 0.2f, 0.5f};
  cloth.width_mm = cloth.depth_mm = kThreads * kSpacing;
  cloth.up = draft::BitMatrix(kThreads, kThreads);
  for (int p = 0; p < kThreads; ++p)
    for (int e = 0; e < kThreads; ++e) cloth.up.set(p, e, (p + e) % 2 == 0);
  return cloth;
}

Curves curves_of(const Cloth& cloth, const CurveOptions& options) {
  base::Result<Curves> made = cloth_curves(cloth, options);
  EXPECT_TRUE(made) << base::problem_of(made);
  return std::move(made).value_or(Curves{});
}

/// Ten by five threads.
CurveOptions patch(CurveDetail detail) {
  CurveOptions options;
  options.low_mm = {2 * kSpacing, kSpacing};
  options.high_mm = options.low_mm + glm::vec2(10 * kSpacing, 5 * kSpacing);
  options.detail = detail;
  return options;
}

TEST(ClothCurves, ThreadsRunFromEdgeToEdgeOfThePatch) {
  const CurveOptions options = patch(CurveDetail::kThreads);
  const Curves curves = curves_of(two_yarns(), options);
  ASSERT_EQ(curves.groups.size(), 2u);
  const CurveGroup &warp = curves.groups[0], &weft = curves.groups[1];
  EXPECT_EQ(warp.name, "Warp_1");
  EXPECT_EQ(weft.name, "Weft_2");
  EXPECT_EQ(warp.points_in.size(), 10u);
  EXPECT_EQ(weft.points_in.size(), 5u);
  EXPECT_EQ(warp.thread.front(), 3) << "the patch begins at end 3";
  EXPECT_EQ(weft.thread.front(), 2);
  EXPECT_FLOAT_EQ(weft.colour.front().b, 0.5f);
  EXPECT_FLOAT_EQ(warp.turns_per_m, 500) << "Z";
  size_t first = 0;
  for (const int count : warp.points_in) {
    EXPECT_NEAR(warp.points[first].y, 0, 1e-4f);
    EXPECT_NEAR(warp.points[first + static_cast<size_t>(count) - 1].y, curves.size_mm.y, 1e-4f);
    first += static_cast<size_t>(count);
  }
  EXPECT_EQ(first, warp.points.size());
  for (const glm::vec4& p : warp.points) EXPECT_NEAR(p.w, std::sqrt(0.5f * 0.4f), 0.02f) << "the area is kept";
}

TEST(ClothCurves, TheWarpIsAboveTheWeftWhereTheDrawdownSaysSo) {
  const Cloth cloth = two_yarns();
  CurveOptions options = patch(CurveDetail::kThreads);
  options.low_mm = {0, 0}, options.high_mm = {cloth.width_mm, cloth.depth_mm};
  const Curves curves = curves_of(cloth, options);
  /// Height of the curve of a thread, at a position along it.
  const auto height = [](const CurveGroup& group, int curve, int along, float at) {
    const auto first = std::accumulate(group.points_in.begin(), group.points_in.begin() + curve, 0);
    for (int k = first; k + 1 < first + group.points_in[static_cast<size_t>(curve)]; ++k) {
      const glm::vec4 a = group.points[static_cast<size_t>(k)], b = group.points[static_cast<size_t>(k) + 1];
      if (a[along] <= at && at <= b[along]) return glm::mix(a, b, (at - a[along]) / (b[along] - a[along])).z;
    }
    return 0.0f;
  };
  for (int p = 0; p < kThreads; ++p)
    for (int e = 0; e < kThreads; ++e) {
      const float warp = height(curves.groups[0], e, 1, cloth.picks[static_cast<size_t>(p)].centre_mm),
                  weft = height(curves.groups[1], p, 0, cloth.ends[static_cast<size_t>(e)].centre_mm);
      EXPECT_EQ(warp > weft, cloth.up.get(p, e)) << "end " << e << ", pick " << p;
      EXPECT_GT(std::abs(warp - weft), 0.3f) << "they touch, and do not pass through each other";
    }
}

TEST(ClothCurves, PliesTurnAboutTheThread) {
  const CurveOptions options = patch(CurveDetail::kPlies);
  const Cloth cloth = two_yarns(2);
  const Curves plies = curves_of(cloth, options), threads = curves_of(cloth, patch(CurveDetail::kThreads));
  const CurveGroup &warp = plies.groups[0], &axes = threads.groups[0];
  ASSERT_EQ(warp.points_in.size(), 2 * axes.points_in.size());
  const auto count = static_cast<size_t>(warp.points_in[0]);
  ASSERT_EQ(count, static_cast<size_t>(axes.points_in[0]));
  float turned = 0;
  for (size_t k = 0; k < count; ++k) {
    const glm::vec3 axis(axes.points[k]), a = glm::vec3(warp.points[k]) - axis,
                                          b = glm::vec3(warp.points[count + k]) - axis;
    EXPECT_LT(glm::length(a + b), 1e-3f) << "they are opposite";
    EXPECT_LT(glm::length(a) + 0.5f * warp.points[k].w, 0.3f) << "in the thread";
    if (k == 0) continue;
    // A Z twist is a right-handed helix about +y.
    const glm::vec3 before = glm::vec3(warp.points[k - 1]) - glm::vec3(axes.points[k - 1]);
    turned += std::atan2(before.z * a.x - before.x * a.z, before.x * a.x + before.z * a.z);
  }
  EXPECT_NEAR(turned, 2 * std::numbers::pi_v<float> * 0.5f * 5 * kSpacing, 0.4f) << "500 turns a metre";
}

TEST(ClothCurves, FibresAreThoseOfThePatchAndTheSeed) {
  const Cloth cloth = two_yarns();
  CurveOptions options = patch(CurveDetail::kFibres);
  const Curves a = curves_of(cloth, options), again = curves_of(cloth, options);
  EXPECT_EQ(a.groups[0].points, again.groups[0].points);
  options.seed = 2;
  EXPECT_NE(a.groups[0].points, curves_of(cloth, options).groups[0].points);
  EXPECT_GT(a.groups[0].points_in.size(), 500u) << "cotton of 10 ends has some hundred fibres in each";
  for (const CurveGroup& group : a.groups)
    for (const glm::vec4& p : group.points) {
      ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
      ASSERT_GT(p.w, 0.001f) << "thinner than a micrometre";
      ASSERT_LT(p.w, 0.1f);
    }
}

TEST(ClothCurves, RefusesWhatIsTooMuchAndWhatIsNothing) {
  CurveOptions options = patch(CurveDetail::kFibres);
  options.high_mm = options.low_mm + glm::vec2(1000);
  const auto much = cloth_curves(two_yarns(), options);
  ASSERT_FALSE(much);
  EXPECT_NE(much.error().text.find("points"), std::string::npos);
  options.high_mm = options.low_mm + glm::vec2(1e-3f);
  EXPECT_FALSE(cloth_curves(two_yarns(), options));
  EXPECT_FALSE(cloth_curves(Cloth{}, CurveOptions{}));
}

}  // namespace
}  // namespace weftlight::reference
