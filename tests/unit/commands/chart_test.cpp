// The chart: error measures, file format, Pareto front, instruction counts, and a quick partial run that is resumed.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "chart/chart_rows.h"
#include "chart/counter.h"
#include "chart/drapes.h"
#include "chart/error.h"
#include "chart/flip.h"
#include "chart/scene.h"
#include "commands/commands.h"
#include "gl/open_headless.h"
#include "weaves/weaves.h"

namespace weftlight::commands {

using base::problem_of;
using chart::ChartLight, chart::ChartRow, chart::ChartScene, chart::ChartSelection, chart::CountedDraw, chart::DrapeRow,
    chart::DrawCounter, chart::FineGrid, chart::PixelSteps, chart::Pixels, chart::box_average, chart::chart_cells,
    chart::chart_csv, chart::chart_effort, chart::chart_view, chart::drape_cells, chart::drape_scene, chart::drapes_csv,
    chart::fine_grid, chart::flicker_of, chart::flip_error, chart::in_scene_colours, chart::kChartFootprints,
    chart::kChartScenes, chart::kChartViews, chart::kDrapeFootprints, chart::kDrapeLights, chart::kDrapedScenes,
    chart::lod_table_csv, chart::lod_table_of, chart::mark_pareto_front, chart::mean_ratio, chart::noise_of,
    chart::pixel_steps, chart::read_chart, chart::relative_rmse;
using design::Design, design::Method;
using draft::Rgb;
using light::LodPoint, light::LodTable, light::choose, light::expected_cost, light::expected_error,
    light::read_lod_table;
using weaves::plain;

namespace {

namespace fs = std::filesystem;

ChartRow row(Method method, double ns, double error, double footprint = 1) {
  ChartRow r;
  r.scene = "plain", r.method = method, r.ns_per_pixel = ns, r.model_error = error, r.yarns_per_pixel = footprint;
  return r;
}

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(chart_error, is_the_rmse_relative_to_the_truth) {
  const Pixels truth{glm::vec3(1), glm::vec3(2)}, picture{glm::vec3(1), glm::vec3(4)};
  EXPECT_NEAR(relative_rmse(picture, truth), std::sqrt(2.0 / 2.5), 1e-9);
  EXPECT_EQ(relative_rmse(truth, truth), 0);
  EXPECT_NEAR(mean_ratio(picture, truth), 5.0 / 3.0, 1e-9);
}

TEST(chart_error, noise_of_two_estimates_of_the_truth_cancels) {
  // The truth is 1; two independent estimates scatter around it by 0.1.
  const Pixels half{glm::vec3(1.1f), glm::vec3(0.9f), glm::vec3(1.1f), glm::vec3(0.9f)};
  const Pixels other{glm::vec3(1.1f), glm::vec3(1.1f), glm::vec3(0.9f), glm::vec3(0.9f)};
  EXPECT_NEAR(relative_rmse(Pixels(4, glm::vec3(1)), half, other), 0, 1e-6);
  EXPECT_NEAR(relative_rmse(Pixels(4, glm::vec3(1.5f)), half, other), 0.5, 1e-6);
  EXPECT_NEAR(noise_of(half, other), 0.5 * std::sqrt(0.02 / 1.01), 1e-6);
}

TEST(chart_error, blocks_are_averaged_and_pans_compared_pixel_by_pixel) {
  const Pixels fine{glm::vec3(1), glm::vec3(3), glm::vec3(10), glm::vec3(20),
                    glm::vec3(5), glm::vec3(7), glm::vec3(30), glm::vec3(40)};
  EXPECT_EQ(box_average(fine, 4, 2, 2, 2), (Pixels{glm::vec3(4), glm::vec3(25)}));
  EXPECT_NEAR(flicker_of({Pixels{glm::vec3(1)}, Pixels{glm::vec3(3)}}), 0.5, 1e-9);
  EXPECT_EQ(flicker_of({Pixels(2, glm::vec3(1)), Pixels(2, glm::vec3(1))}), 0);
}

TEST(flip, is_zero_for_equal_pictures_and_nearly_one_from_black_to_white) {
  constexpr int kSide = 24;
  const Pixels black(kSide * kSide, glm::vec3(0)), white(kSide * kSide, glm::vec3(1));
  EXPECT_EQ(flip_error(white, white, kSide, kSide), 0);
  // Its authors: black and white are 100 apart, the farthest colours (green and blue) 41.276^(1/0.7) = 203.
  EXPECT_NEAR(flip_error(black, white, kSide, kSide), 0.967, 2e-3);
  Pixels line = white;  // an edge is more visible than a uniform change with the same mean
  for (int y = 0; y < kSide; ++y) line[static_cast<size_t>(y * kSide + kSide / 2)] = glm::vec3(0);
  const Pixels grey(kSide * kSide, glm::vec3(1 - 1.0f / kSide));
  EXPECT_GT(flip_error(line, white, kSide, kSide), flip_error(grey, white, kSide, kSide));
  EXPECT_NEAR(flip_error(line, white, kSide, kSide), flip_error(white, line, kSide, kSide), 1e-12);
}

TEST(chart_rows, on_front_means_that_no_other_is_better_in_both) {
  std::vector<ChartRow> rows{row(Method::kFlat, 1, 0.9), row(Method::kCloth, 2, 0.3), row(Method::kEngine, 3, 0.4),
                             row(Method::kYarn, 9, 0.1), row(Method::kAuto, 9, 0.1),  row(Method::kCell, 0.5, 0.01, 2)};
  mark_pareto_front(rows);
  const std::vector<bool> expected{true, true, false, true, true, true};
  for (size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].on_front, expected[i]) << i;
}

TEST(chart_rows, survive_a_round_trip_through_text) {
  ChartRow r = row(Method::kRepeat, 12.5, 0.123456789, 0.125);
  r.view_deg = 80, r.bytes = 22369600, r.on_front = true;
  const std::string text = chart_csv({r});
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "scene,view_deg,yarns_per_pixel,method,samples,ns_per_pixel,instructions_per_pixel,rel_rmse_model,rel_rmse_"
            "filtering,"
            "flip,energy_ratio,flicker,bytes,on_front");
  const std::vector<ChartRow> back = read_chart(text);
  ASSERT_EQ(back.size(), 1u);
  EXPECT_TRUE(back[0].same_cell(r));
  EXPECT_EQ(chart_csv(back), text);
  EXPECT_TRUE(read_chart("scene,view\nplain,0\n").empty());
  EXPECT_EQ(read_chart(text + "plain,0,half a li").size(), 1u);
}

TEST(chart_rows, make_a_lod_table_that_can_be_read_again) {
  std::vector<ChartRow> rows;
  for (const double footprint : {0.5, 2.0}) {
    rows.push_back(row(Method::kYarn, 40, 0.1 * footprint, footprint));
    rows.push_back(row(Method::kCloth, 10, 0.4 / footprint, footprint));
  }
  rows.push_back(row(Method::kYarn, 60, 0.3, 2));  // another cloth, worse
  rows.back().scene = "satin";
  const LodTable lod_table = lod_table_of(rows);
  const base::Result<LodTable> read = read_lod_table(lod_table_csv(lod_table));
  ASSERT_EQ(problem_of(read), "");
  const LodTable& again = *read;
  EXPECT_EQ(again.size(), lod_table.size());
  EXPECT_NEAR(expected_error(again, Method::kYarn, 2), 0.3f, 1e-5f);  // the worst scene
  EXPECT_NEAR(expected_cost(again, Method::kYarn, 2), 50, 1e-3f);
  EXPECT_EQ(choose(again, 0.5f, {0.06f}).method, Method::kYarn);  // none is below the tolerance: the best
  EXPECT_EQ(choose(again, 2, {0.25f}).method, Method::kCloth);
}

TEST(chart_scene, pixels_are_stretched_by_the_tilt) {
  const PixelSteps flat = pixel_steps(0, 2), tilted = pixel_steps(80, 2);
  EXPECT_NEAR(glm::length(flat.y), 2, 1e-5);
  EXPECT_NEAR(glm::length(tilted.x), 2, 1e-5);
  EXPECT_NEAR(glm::length(tilted.y), 2 / std::cos(80 * 0.0174532925), 1e-4);
  // Rows run towards the eye.
  EXPECT_GT(glm::dot(tilted.y, glm::vec2(chart_view(80))), 0);
  const FineGrid grid = fine_grid(80, 8, chart_effort(false));
  EXPECT_GE(grid.nx * grid.ny, 1024);
  EXPECT_LE(8 / std::cos(80 * 0.0174532925) / grid.ny, 1.0 / 16 + 1e-9);
}

TEST(chart_scene, one_has_black_and_white_threads_only) {
  Design design = plain({4, 4});
  design.draft.palette = {{0.2f, 0.4f, 0.6f}, {0.5f, 0.5f, 0.5f}};
  for (const ChartScene& scene : kChartScenes) {
    const std::vector<Rgb> palette = in_scene_colours(design, scene).draft.palette;
    if (scene.black_white) EXPECT_EQ(palette, (std::vector<Rgb>{{0, 0, 0}, {1, 1, 1}}));
    else EXPECT_EQ(palette, design.draft.palette);
  }
  EXPECT_EQ(std::count_if(kChartScenes.begin(), kChartScenes.end(), [](const ChartScene& s) { return s.black_white; }),
            1);
}

TEST(draw_counter, is_reproducible_and_proportional_to_the_work) {
  volatile double sum = 0;
  const auto counter = DrawCounter::start([&sum](const CountedDraw& what, const LodTable&, int pixels) {
    for (int i = 0; i < pixels * pixels * what.samples; ++i) sum = sum + 1.5;
    return true;
  });
  if (!counter) GTEST_SKIP() << "not supported on this processor";
  CountedDraw what;
  const auto one = counter->per_pixel(what, {});
  EXPECT_EQ(counter->per_pixel(what, {}), one);
  what.samples = 4;
  const auto four = counter->per_pixel(what, {LodPoint{}});
  ASSERT_TRUE(one && four);
  EXPECT_NEAR(*four / *one, 4, 0.01);
}

TEST(draw_counter, is_empty_if_drawing_fails) {
  const auto counter = DrawCounter::start([](const CountedDraw&, const LodTable&, int) { return false; });
  if (!counter) GTEST_SKIP() << "not supported on this processor";
  EXPECT_FALSE(counter->per_pixel({}, {}));
  EXPECT_FALSE(counter->per_pixel({}, {}));
}

class ChartRun : public ::testing::Test {
 protected:
  void SetUp() override {
    if (const auto context = gl::open_headless(); !context) GTEST_SKIP() << "no graphics: " << problem_of(context);
    dir_ = fs::path(::testing::TempDir()) / ("weftlight-chart-" + std::to_string(::getpid()));
  }
  void TearDown() override {
    std::error_code ignored;
    fs::remove_all(dir_, ignored);
  }
  /// Measures the cheapest cloth at a small and a large footprint.
  int run(std::vector<int> views) const {
    return chart_command({dir_.string(), true, false, {{"plain"}, std::move(views), {0.125, 2}}});
  }
  std::vector<ChartRow> rows() const { return read_chart(read(dir_ / "chart.csv")); }
  fs::path dir_;
};

TEST(chart_cells, are_every_combination_once) {
  const std::vector<ChartRow> all = chart_cells({Method::kFlat, Method::kYarn, Method::kAuto});
  EXPECT_EQ(all.size(), kChartScenes.size() * kChartViews.size() * kChartFootprints.size() * (2 + formulas::kLattices));
  for (size_t i = 0; i < all.size(); ++i) {
    for (size_t k = 0; k < i; ++k) EXPECT_FALSE(all[i].same_cell(all[k])) << i << " and " << k;
  }
}

TEST(chart_cells, of_a_selection_match_its_values) {
  const std::vector<ChartRow> all = chart_cells({Method::kFlat, Method::kCloth});
  const auto held = [&all](const ChartSelection& selection) {
    return std::count_if(all.begin(), all.end(), [&selection](const ChartRow& r) { return selection.holds(r); });
  };
  EXPECT_EQ(held({}), std::ssize(all));
  EXPECT_EQ(held({{"satin"}, {}, {}}), 2 * 2 * 6);
  EXPECT_EQ(held({{"satin", "plain"}, {80}, {0.125, 2}}), 2 * 1 * 2 * 2);
}

TEST(chart_drapes, are_two_cloths_in_three_lights_at_each_footprint) {
  const std::vector<DrapeRow> all = drape_cells({Method::kFlat, Method::kAuto}, chart_effort(false));
  ASSERT_EQ(all.size(), kDrapedScenes.size() * kDrapeLights.size() * kDrapeFootprints.size() * 2);
  const std::string text = drapes_csv({all.front()});
  EXPECT_EQ(text,
            "mesh,scene,light,yarns_per_pixel,method,ns_per_pixel,rel_rmse_model,flip,energy_ratio,rel_rmse_noise\n"
            "curtain,plain,key,0.5,flat,0,0,0,1,0\n");
  EXPECT_EQ(drape_scene(ChartLight::kKey).sky_strength, 0);
  EXPECT_EQ(drape_scene(ChartLight::kSky).light_strength, 0);
  for (const char* name : kDrapedScenes) {
    EXPECT_TRUE(std::any_of(kChartScenes.begin(), kChartScenes.end(),
                            [name](const ChartScene& scene) { return std::string(scene.name) == name; }));
  }
}

TEST_F(ChartRun, measures_a_part_and_resumes) {
  ASSERT_EQ(run({0}), kDone);
  const std::vector<ChartRow> flat = rows();
  std::set<Method> methods;
  for (const ChartRow& r : flat) methods.insert(r.method);
  EXPECT_GE(methods.size(), 3u);
  const size_t of_yarn = methods.contains(Method::kYarn) ? formulas::kLattices : 1;
  EXPECT_EQ(flat.size(), 2 * (methods.size() - 1 + of_yarn));
  for (const ChartRow& r : flat) {
    EXPECT_GT(r.ns_per_pixel, 0);
    EXPECT_GT(r.energy_ratio, 0);
    EXPECT_GE(r.model_error, 0);
  }

  // After removing two rows and requesting more, the remaining rows keep their timings.
  std::ofstream(dir_ / "chart.csv", std::ios::binary) << chart_csv({flat.begin(), flat.end() - 2});
  ASSERT_EQ(run({80}), kDone);
  const std::vector<ChartRow> both = rows();
  ASSERT_EQ(both.size(), 2 * flat.size() - 2);
  for (size_t i = 0; i + 2 < flat.size(); ++i) EXPECT_EQ(both[i].ns_per_pixel, flat[i].ns_per_pixel);

  for (const char* picture : {"error_cost", "error_footprint", "filtering_footprint", "albedo", "memory"}) {
    for (const char* kind : {".svg", ".png", ".csv"})
      EXPECT_TRUE(fs::exists(dir_ / (std::string(picture) + kind))) << picture << kind;
  }
  EXPECT_GT(read(dir_ / "frames.csv").size(), 200u);
  EXPECT_NE(read(dir_ / "light.csv").find("behind,plain,60,2,cloth,"), std::string::npos);
  const std::string drapes = read(dir_ / "drapes.csv");
  EXPECT_EQ(std::count(drapes.begin(), drapes.end(), '\n'), 1 + std::ssize(kDrapeLights) * std::ssize(methods));
  // The energy of the drape is about that of its traced threads.
  for (const std::string row : {"curtain,plain,key,4,cloth,", "curtain,plain,sky,4,repeat,"}) {
    const size_t at = drapes.find(row);
    ASSERT_NE(at, std::string::npos) << row;
    double ns = 0, error = 0, flip = 0, energy = 0;
    ASSERT_EQ(std::sscanf(drapes.c_str() + at + row.size(), "%lf,%lf,%lf,%lf", &ns, &error, &flip, &energy), 4);
    EXPECT_GT(ns, 0);
    EXPECT_NEAR(energy, 1, 0.1) << row;
    EXPECT_LT(error, 0.25) << row;
    EXPECT_LT(flip, 0.15) << row;
  }
  // As bright as the fibres on the mean of all lights and views, hence about so in these.
  const std::string fibres = read(dir_ / "fibres.csv");
  for (const std::string row : {"plain,0,0.25,tubes,0,", "plain,60,0.25,yarn,5,", "plain,0,0.25,repeat,1,"}) {
    const size_t at = fibres.find(row);
    ASSERT_NE(at, std::string::npos) << row << " in\n" << fibres;
    double error = 0, of_tubes = 0, flip = 0, energy = 0;
    ASSERT_EQ(std::sscanf(fibres.c_str() + at + row.size(), "%lf,%lf,%lf,%lf", &error, &of_tubes, &flip, &energy), 4);
    EXPECT_NEAR(energy, 1, 0.5) << row;
    EXPECT_LT(error, 0.9) << row;
    EXPECT_LE(of_tubes, 0.5) << row;
  }
}

TEST(chart_command, reports_that_the_folder_cannot_be_made) {
  EXPECT_EQ(chart_command({"/dev/null/chart", true, false, {}}), kNotWritten);
}

}  // namespace
}  // namespace weftlight::commands
