#pragma once
// What the chart measures on: four cloths, two views, five footprints, one light; and the pixels of each.

#include <array>
#include <glm/glm.hpp>
#include <string>

#include "commands/names.h"
#include "light/ladder.h"

namespace weftlight::commands {

struct ChartScene {
  const char* name;
  const char* preset;  // presets/drafts
};
inline constexpr std::array<ChartScene, 4> kChartScenes{
    {{"plain", "plain.wif"}, {"twill", "twill_2_2.wif"}, {"satin", "satin_8.wif"}, {"damask", "twill_damask.wif"}}};
inline constexpr std::array<int, 2> kChartViews{0, 80};                        // degrees from the normal
inline constexpr std::array<double, 5> kChartFootprints{0.125, 0.5, 1, 2, 8};  // yarns a pixel
inline constexpr std::array kChartMethods{Method::kFlat, Method::kVrst03, Method::kCloth,  Method::kRepeat,
                                          Method::kCell, Method::kYarn,   Method::kEngine, Method::kAuto};

/// Towards the eye, tilted by so many degrees on an azimuth that is no thread's.
glm::vec3 chart_view(double degrees);
/// Towards the light: 40 degrees from the normal, on another azimuth.
glm::vec3 chart_light();

/// One pixel on the plane as a camera at chart_view sees it: `side_mm` across the tilt, longer along it.
struct PixelSteps {
  glm::vec2 x, y;  // rows run down
};
PixelSteps pixel_steps(double view_deg, double side_mm);

/// How much is spent on a figure.
struct ChartEffort {
  double samples_a_yarn = 16;  // of the finer picture, along each side, and never less than 32 a pixel
  int fine_budget = 260'000;   // pixels of the finer picture, where 4 x 4 pixels do not need more
  int fine_samples = 16;       // of rung yarn in each: the light's disc must be covered, too
  int truth_budget = 150'000;  // rays of each half of the truth
  int timing_size = 256, timing_repeats = 5;
  int pans = 8;
  int counted_samples = 6;          // of rung yarn; one of six follows a ray to the light
  double timing_enough_ns = 1.5e9;  // of pictures that are slow enough to be timed by few
  bool count_everywhere = true;     // instructions: else in the first scene, seen straight on
  int patch_least = 16;             // pixels along a side
  double patch_yarns = 8;           // or more, to hold so many
  int tube_facets = 48;             // of the truth
};
ChartEffort chart_effort(bool quick);

/// Pixels along a side of the patch.
int patch_pixels(double yarns_per_pixel, const ChartEffort& effort);

/// Grid of the finer picture: samples a pixel, and how many pixels the budget holds.
struct FineGrid {
  int nx = 32, ny = 32;  // samples a pixel
  int pixels = 16;       // along a side
};
FineGrid fine_grid(double view_deg, double yarns_per_pixel, const ChartEffort& effort);

}  // namespace weftlight::commands
