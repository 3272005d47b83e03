// Horizon, footprint, LOD table, and the GLSL syntax of the shared files.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

#include "light/lod_table.h"
#include "paths.h"
#include "sampling.h"

namespace weftlight::light {

using base::problem_of;
using design::Method, design::MethodFacts, design::kMethods, design::method_from_name, design::method_name;

namespace {

float horizon_of(float azimuth) { return 0.4f + 0.3f * std::cos(azimuth) + 0.1f * std::sin(2 * azimuth); }

TEST(Horizon, TurningLightMeetsNoRipple) {
  const int n = 16;
  std::vector<float> bins;
  for (int k = 0; k < n; ++k) bins.push_back(horizon_of(2 * formulas::kPi * static_cast<float>(k) / n));
  float cubic = 0, nearest = 0;
  for (int d = -720; d < 720; ++d) {
    const float a = static_cast<float>(d) * formulas::kPi / 360 + 1e-3f;
    const auto taps = formulas::horizon_taps(a, n);
    glm::vec4 v;
    for (int k = 0; k < 4; ++k) v[k] = bins[static_cast<size_t>(taps.at[k])];
    cubic = std::max(cubic, std::abs(formulas::horizon_mix(taps, v) - horizon_of(a)));
    // One boolean map a bin, as in the paper, is off by a whole step of the horizon.
    nearest = std::max(nearest, std::abs(v[1] - horizon_of(a)));
  }
  EXPECT_LT(cubic, 0.004f);
  EXPECT_GT(nearest, 20 * cubic);
}

TEST(Horizon, TapsAreValidForAnyAzimuthAndCount) {
  for (const int n : {1, 2, 3, 16, 64})
    for (const float a : {0.0f, -1e-9f, 6.2831853f, -6.2831853f, 1e4f, -1e4f, 3.0f}) {
      const auto t = formulas::horizon_taps(a, n);
      for (int k = 0; k < 4; ++k) EXPECT_TRUE(t.at[k] >= 0 && t.at[k] < n) << n << " " << a;
      EXPECT_NEAR(t.weight.x + t.weight.y + t.weight.z + t.weight.w, 1, 1e-5f);
    }
}

TEST(Horizon, VisibilityRisesWithElevationAndSoftensWithTheLight) {
  float last = -1;
  for (int i = 0; i <= 100; ++i) {
    const float s = 0.01f * static_cast<float>(i);
    const float v = formulas::horizon_visibility(s, 0.5f, 0.1f, 0.02f);
    EXPECT_GE(v, last);
    last = v;
  }
  EXPECT_NEAR(formulas::horizon_visibility(0.5f, 0.5f, 0.1f, 0.02f), 0.5f, 1e-3f);
  EXPECT_GT(formulas::horizon_visibility(0.9f, 0.2f, 0.05f, 0.005f), 0.999f);
  EXPECT_LT(formulas::horizon_visibility(0.1f, 0.6f, 0.05f, 0.005f), 0.001f);
  EXPECT_GT(formulas::horizon_visibility(0.45f, 0.5f, 0, 0.3f), formulas::horizon_visibility(0.45f, 0.5f, 0, 0.01f));
}

TEST(Coverage, GapsCloseWithTheViewAngle) {
  const glm::vec2 gap(0.1f, 0.2f);
  EXPECT_NEAR(formulas::coverage_by_view(0.9f, gap, 0.2f, {0, 0, 1}), 0.9f, 1e-5f);
  float last = 0;
  for (int i = 0; i < 18; ++i) {
    const float d = 5 * static_cast<float>(i);
    const float c = formulas::coverage_by_view(0.9f, gap, 0.2f, at_degrees(d, 20));
    EXPECT_GE(c, last);
    last = c;
  }
  EXPECT_GT(formulas::coverage_by_view(0.9f, gap, 0.2f, at_degrees(80, 0)), 0.995f);
  EXPECT_GT(formulas::coverage_by_view(0.9f, gap, 0.2f, at_degrees(89.9f, 45)), 0.9999f);
  // A gap stays open longer along than across.
  EXPECT_LT(formulas::coverage_by_view(0.9f, {0.1f, 10}, 0.2f, at_degrees(60, 90)),
            formulas::coverage_by_view(0.9f, {0.1f, 10}, 0.2f, at_degrees(60, 0)));
  EXPECT_EQ(formulas::coverage_by_view(1, {0, 0}, 0, {0, 0, 1}), 1);
}

TEST(Masking, HigherThreadsHideLowerOnesAtGrazing) {
  const glm::vec2 fraction(0.5f, 0.5f), flat(1, 1);
  for (const float d : {0.0f, 60.0f, 85.0f, 89.9f}) {
    const glm::vec2 m = formulas::system_masking(fraction, flat * 0.5f, -0.4f, at_degrees(d, 90));
    EXPECT_NEAR(fraction.x * m.x + fraction.y * m.y, 1, 1e-4f) << d;
    if (d > 80) {
      EXPECT_LT(m.x, 0.3f * m.y) << d;
    }
  }
  const glm::vec2 front = formulas::system_masking(fraction, flat, -0.4f, {0, 0, 1});
  EXPECT_NEAR(front.x, 1, 1e-5f);
  // Wefts run along x: a view along x looks along the gaps between them.
  EXPECT_GT(formulas::system_masking(fraction, flat, -0.4f, at_degrees(80, 0)).x, 0.99f);
}

TEST(LodWeights, WeightsSumToOneAndFollowTheFootprint) {
  const glm::vec3 edges(0.25f, 2, 8);
  for (int i = 0; i < 123; ++i) {
    const float yarns = std::pow(1.07f, static_cast<float>(i)) / 64;  // to 64
    const glm::vec4 w = formulas::lod_weights(yarns, edges);
    EXPECT_NEAR(w.x + w.y + w.z + w.w, 1, 1e-5f);
    EXPECT_GE(std::min(std::min(w.x, w.y), std::min(w.z, w.w)), 0);
  }
  EXPECT_EQ(formulas::lod_weights(0.1f, edges).x, 1);
  EXPECT_EQ(formulas::lod_weights(0.7f, edges).y, 1);
  EXPECT_EQ(formulas::lod_weights(4, edges).z, 1);
  EXPECT_EQ(formulas::lod_weights(20, edges).w, 1);
  EXPECT_EQ(formulas::lod_weights(0, edges).x, 1);
  // At its edge the coarser method has full weight.
  EXPECT_EQ(formulas::lod_weights(2, edges).z, 1);
  EXPECT_EQ(formulas::lod_weights(8, edges).w, 1);
  EXPECT_GT(formulas::lod_weights(1.9f, edges).y, 0);
  EXPECT_FLOAT_EQ(formulas::footprint_yarns({0.3f, 0.4f}, {0, 0.1f}, 0.25f), 2);
}

TEST(LodTable, NamesComeBack) {
  for (const MethodFacts& m : kMethods) {
    EXPECT_EQ(method_from_name(m.name), m.method);
    EXPECT_EQ(method_name(m.method), m.name);
  }
  EXPECT_FALSE(method_from_name("Yarn"));
  EXPECT_FALSE(method_from_name(""));
}

TEST(LodTable, DefaultBandsAreTheModels) {
  const LodTable lod_table = default_lod_table();
  EXPECT_EQ(choose(lod_table, 0.1f, {0.05f}).method, Method::kYarn);
  EXPECT_EQ(choose(lod_table, 1, {0.05f}).method, Method::kCell);
  EXPECT_EQ(choose(lod_table, 4, {0.05f}).method, Method::kRepeat);
  EXPECT_EQ(choose(lod_table, 20, {0.05f}).method, Method::kCloth);
  const auto edges = plan_of(lod_table, {0.05f}).methods;
  EXPECT_NEAR(std::log2(edges[0]), -2, 0.51f);
  EXPECT_NEAR(std::log2(edges[1]), 1, 0.51f);
  EXPECT_NEAR(std::log2(edges[2]), 3, 0.51f);
}

TEST(LodTable, MoreToleranceNeverAsksForMore) {
  const LodTable lod_table = default_lod_table();
  auto last = plan_of(lod_table, {0.01f}).methods;
  for (const float tolerance : {0.05f, 0.1f, 0.5f}) {
    const auto edges = plan_of(lod_table, {tolerance}).methods;
    EXPECT_LE(edges[0], edges[1]);
    EXPECT_LE(edges[1], edges[2]);
    for (size_t k = 0; k < 3 && tolerance > 0.05f; ++k) EXPECT_LE(edges[k], last[k]);
    last = edges;
  }
}

TEST(LodTable, SamplesFollowToleranceAndFootprint) {
  // Half the error at four times the samples, as much again every octave.
  LodTable lod_table;
  for (int i = 0; i < formulas::kLattices; ++i) {
    for (const float yarns : {0.0625f, 0.25f, 1.0f}) {
      const int samples = formulas::lattice_of(i).x;
      const float error = 0.3f * yarns / std::sqrt(static_cast<float>(samples));
      lod_table.push_back({Method::kYarn, yarns, 10.0f * static_cast<float>(samples), error, error, samples});
    }
  }
  const Plan loose = plan_of(lod_table, {0.15f}), tight = plan_of(lod_table, {0.05f});
  EXPECT_EQ(samples_at(loose, 0.06f), 1);
  EXPECT_EQ(samples_at(loose, 1), 5);  // 4 would suffice
  EXPECT_EQ(samples_at(tight, 1), formulas::kMaxYarnSamples);
  for (int i = 0; i < 46; ++i) {
    const float yarns = 0.05f * std::pow(1.1f, static_cast<float>(i));  // to 4
    EXPECT_GE(samples_at(tight, yarns), samples_at(loose, yarns)) << yarns;
    EXPECT_GE(samples_at(loose, yarns * 1.1f), samples_at(loose, yarns)) << yarns;
  }
  EXPECT_LE(samples_at(plan_of(lod_table, {0.01f, 2}), 1), 2);
  EXPECT_GT(expected(lod_table, tight, 1).cost_ns, expected(lod_table, loose, 1).cost_ns);
  EXPECT_LT(expected(lod_table, tight, 1).error, expected(lod_table, loose, 1).error);
}

TEST(LodTable, CellIsNotKeptWhereItNoLongerHolds) {
  // As measured on a twill: `cell` is cheaper than `repeat`, and less accurate from one yarn a pixel down.
  LodTable lod_table;
  const auto add = [&lod_table](Method method, int samples, float cost, std::array<float, 3> errors) {
    for (size_t i = 0; i < 3; ++i) {
      const float yarns = std::exp2(static_cast<float>(i) - 1.5f);
      lod_table.push_back({method, yarns, cost, errors[i], errors[i], samples});
    }
  };
  add(Method::kYarn, 2, 540, {0.38f, 0.46f, 0.47f});
  add(Method::kYarn, 3, 770, {0.27f, 0.32f, 0.35f});
  add(Method::kCell, 1, 164, {0.49f, 0.40f, 0.34f});
  add(Method::kRepeat, 1, 265, {0.43f, 0.32f, 0.25f});
  add(Method::kCloth, 1, 102, {0.56f, 0.43f, 0.33f});
  float last = 0;
  for (const float tolerance : {0.34f, 0.38f, 0.42f, 0.46f, 0.5f}) {
    const float error = expected(lod_table, plan_of(lod_table, {tolerance}), 0.5f).error;
    EXPECT_LE(error, tolerance) << tolerance;
    EXPECT_GE(error, last - 1e-4f) << tolerance;
    last = error;
  }
}

TEST(Lattice, PointsSpreadOverThePixelAndPassesFillIn) {
  using formulas::kLattices, formulas::kMaxYarnSamples, formulas::lattice_of, formulas::lattice_point;
  using glm::ivec2, glm::vec2;
  EXPECT_EQ(lattice_of(kLattices - 1).x, kMaxYarnSamples);
  for (int k = 0; k < kLattices; ++k) {
    const ivec2 lattice = lattice_of(k);
    double x = 0, least = 1;
    std::vector<vec2> points;
    for (int i = 0; i < lattice.x; ++i) {
      const vec2 p = lattice_point(lattice, i, 0, 0);
      EXPECT_TRUE(std::abs(p.x) <= 0.5f && std::abs(p.y) <= 0.5f);
      x += static_cast<double>(p.x);
      for (const vec2& q : points) {
        const vec2 d = p - q - round(p - q);  // pixels lie side by side
        least = std::min(least, static_cast<double>(length(d)));
      }
      points.push_back(p);
    }
    EXPECT_NEAR(x, 0, 1e-5);
    // The densest packing of n points has a distance of sqrt(1.155 / n); these have at least 0.6 of it.
    if (k > 0) {
      EXPECT_GT(least, 0.6 * std::sqrt(1.155 / lattice.x)) << lattice.x;
    }
  }
  // Forty passes of two points: no two points are close.
  double least = 1;
  std::vector<vec2> all;
  for (int pass = 0; pass < 40; ++pass) {
    for (int i = 0; i < 2; ++i) {
      const vec2 p = lattice_point(lattice_of(1), i, pass, 0);
      for (const vec2& q : all) least = std::min(least, static_cast<double>(length(p - q - round(p - q))));
      all.push_back(p);
    }
  }
  EXPECT_GT(least, 0.25 * std::sqrt(1.155 / 80));
}

TEST(LodTable, ReadsWhatTheChartWrote) {
  const std::string csv =
      "scene,view_deg,yarns_per_pixel,method,samples,ns_per_pixel,instructions_per_pixel,rel_rmse_model,"
      "rel_rmse_filtering,energy_ratio,flicker,bytes,on_front\r\n"
      "plain,0,1,cell,1,20,100,0.1,0.02,1,0,10,1\r\n"
      "satin,80,1,cell,1,30,100,0.05,0.12,1,0,10,1\r\n"
      "satin,80,4,cell,1,30,100,0.3,0.12,1,0,10,0\r\n"
      "satin,80,4,yarn,8,90,100,0.03,0.02,1,0,10,0\r\n";
  const base::Result<LodTable> read = read_lod_table(csv);
  ASSERT_EQ(problem_of(read), "");
  const LodTable& lod_table = *read;
  ASSERT_EQ(lod_table.size(), 3u);
  EXPECT_FLOAT_EQ(expected_error(lod_table, Method::kCell, 1), 0.12f);
  EXPECT_FLOAT_EQ(expected_error(lod_table, Method::kCell, 2), 0.21f);
  EXPECT_FLOAT_EQ(expected_cost(lod_table, Method::kCell, 1), 25);
  EXPECT_FLOAT_EQ(expected_error(lod_table, Method::kYarn, 1, 8), 0.03f);
  EXPECT_TRUE(std::isinf(expected_error(lod_table, Method::kYarn, 1, 5)));
  EXPECT_NE(problem_of(read_lod_table("scene,method,samples\n")).find("yarns_per_pixel"), std::string::npos);
  for (const char* bad : {"plain,0,nan,cell,1,1,1,1,1,1,0,1,1\n", "plain,0,1,yarn,0,1,1,1,1,1,0,1,1\n",
                          "plain,0,1,yarn,1e9,1,1,1,1,1,0,1,1\n"}) {
    const std::string problem = problem_of(read_lod_table(csv + bad));
    EXPECT_NE(problem.find("line 6"), std::string::npos) << problem;
  }
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::stringstream s;
  s << in.rdbuf();
  return s.str();
}

TEST(Glsl, EveryFormulaFileParses) {
  if (std::system("glslangValidator --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "glslangValidator is not installed";
  const std::filesystem::path shaders = std::filesystem::path(WEFTLIGHT_SOURCE_DIR) / "shaders";
  for (const char* file : {"lobes.glsl", "vrst03.glsl", "horizon.glsl", "filter.glsl", "lattice.glsl"}) {
    std::string text = "#version 330 core\n";
    if (std::string_view(file) == "lobes.glsl") text += text_of(shaders / "tables.glsl");
    const std::string body = text_of(shaders / file);
    ASSERT_FALSE(body.empty()) << file;
    text += body + "\nvoid main() {}\n";
    const auto path = std::filesystem::temp_directory_path() / ("weftlight_formula_" + std::string(file) + ".frag");
    std::ofstream(path) << text;
    EXPECT_EQ(std::system(("glslangValidator " + path.string()).c_str()), 0) << file;
    std::filesystem::remove(path);
  }
}

}  // namespace
}  // namespace weftlight::light
