#pragma once
// The conditions of the chart: five cloths, two views, six footprints, one light; and the pixels of each.

#include <array>
#include <glm/glm.hpp>
#include <string>

#include "design/design.h"
#include "light/lod_table.h"

namespace weftlight::chart {

using design::Design;

struct ChartScene {
  const char* name;
  const char* preset;        // presets/drafts
  bool black_white = false;  // the first colour of its palette black, the others white
};
inline constexpr std::array<ChartScene, 5> kChartScenes{{{"plain", "plain.wif"},
                                                         {"twill", "twill_2_2.wif"},
                                                         {"satin", "satin_8.wif"},
                                                         {"black_white", "shot_taffeta.wif", true},
                                                         {"damask", "twill_damask.wif"}}};
/// The scene's draft in its colours.
Design in_scene_colours(Design design, const ChartScene& scene);

inline constexpr std::array<int, 2> kChartViews{0, 80};                                // degrees from the normal
inline constexpr std::array<double, 6> kChartFootprints{0.0625, 0.125, 0.5, 1, 2, 8};  // yarns per pixel

/// Direction of the viewer, tilted from the normal on an azimuth that is not along a thread.
glm::vec3 chart_view(double degrees);
/// Direction of the light: 40 degrees from the normal, on another azimuth.
glm::vec3 chart_light();

/// The key light, and lights for separate rows: the sky only, with radiance 1 at the top and 0 at the bottom, and the
/// key light from behind the cloth.
enum class ChartLight { kKey, kSky, kBehind };
constexpr const char* light_name(ChartLight light) {
  return light == ChartLight::kKey ? "key" : light == ChartLight::kSky ? "sky" : "behind";
}

/// One pixel on the plane as a camera at chart_view sees it: `side_mm` across the tilt, longer along it.
struct PixelSteps {
  glm::vec2 x, y;  // rows run down
};
PixelSteps pixel_steps(double view_deg, double side_mm);

/// The table of frames: sizes in pixels, yarns per pixel, and tolerances of `auto`.
inline constexpr std::array<std::array<int, 2>, 3> kFrameSizes{{{1280, 720}, {1920, 1080}, {3840, 2160}}};
inline constexpr std::array<double, 8> kFrameFootprints{0.0625, 0.125, 0.25, 0.5, 1, 2, 4, 8};
inline constexpr std::array<float, 3> kFrameTolerances{0.05f, 0.15f, 0.3f};

/// The effort for a measurement.
struct ChartEffort {
  double samples_per_yarn = 16;  // of the supersampled picture, per side, and at least 32 per pixel
  int fine_budget = 260'000;     // samples of the supersampled picture, unless 4 x 4 pixels need more
  int fine_samples = 5;          // of method yarn in each, to cover the disc of the light too
  int truth_budget = 150'000;    // rays of each half of the truth
  int timing_size = 256, timing_repeats = 5;
  int yarn_timing_size = 128;  // it is much slower
  // On a graphics card, which small patches leave idle.
  int card_timing_size = 1024, card_yarn_timing_size = 512;
  int pans = 8;
  double timing_enough_ns = 1.5e9;  // time after which no more repeats are needed
  bool count_instructions = false;  // by single steps, which take minutes per row
  int frame_size = 128;             // frames of a software renderer are scaled from a patch with this side in pixels
  int min_patch_pixels = 16;        // along a side
  double patch_yarns = 8;           // or more pixels, to contain this many yarns
  int tube_facets = 48;             // in the truth
  int fibre_pixels = 96;            // most along a side of a patch of fibres
  size_t fibre_footprints = 4;      // the last ones of kFibreFootprints
  int drape_width = 96, drape_height = 16;  // pixels; folds run along the height
  int drape_rays = 100'000;                 // of each half of its truth
  int drape_timing_size = 128, drape_yarn_timing_size = 64;
  size_t drape_footprints = 3;  // the last ones of kDrapeFootprints
};
ChartEffort chart_effort(bool quick);

/// Pixels along a side of the patch.
int patch_pixels(double yarns_per_pixel, const ChartEffort& effort);

/// Grid of the supersampled picture: samples per pixel, and the number of pixels in the budget.
struct FineGrid {
  int nx = 32, ny = 32;  // samples per pixel
  int pixels = 16;       // along a side
};
FineGrid fine_grid(double view_deg, double yarns_per_pixel, const ChartEffort& effort);

}  // namespace weftlight::chart
