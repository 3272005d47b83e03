#include "chart/scene.h"

#include <algorithm>
#include <cmath>

namespace weftlight::chart {

using draft::Rgb;

namespace {

constexpr double kViewAzimuth = -73, kLightAzimuth = 35, kLightTilt = 40;  // degrees; 0 is along the weft

double radians(double degrees) { return degrees * 0.017453292519943295; }

glm::dvec2 around(double azimuth_deg) { return {std::cos(radians(azimuth_deg)), std::sin(radians(azimuth_deg))}; }

glm::vec3 tilted(double azimuth_deg, double degrees) {
  return glm::vec3(glm::dvec3(around(azimuth_deg) * std::sin(radians(degrees)), std::cos(radians(degrees))));
}

}  // namespace

Design in_scene_colours(Design design, const ChartScene& scene) {
  if (!scene.black_white) return design;
  std::fill(design.draft.palette.begin(), design.draft.palette.end(), Rgb{1, 1, 1});
  if (!design.draft.palette.empty()) design.draft.palette.front() = {0, 0, 0};
  return design;
}

glm::vec3 chart_view(double degrees) { return tilted(kViewAzimuth, degrees); }
glm::vec3 chart_light() { return tilted(kLightAzimuth, kLightTilt); }

PixelSteps pixel_steps(double view_deg, double side_mm) {
  const glm::dvec2 towards = around(kViewAzimuth);  // the near edge is the lower one
  return {glm::vec2(glm::dvec2(-towards.y, towards.x) * side_mm),
          glm::vec2(towards * (side_mm / std::cos(radians(view_deg))))};
}

ChartEffort chart_effort(bool quick) {
  if (!quick) return {};
  ChartEffort e;
  e.samples_per_yarn = 4, e.fine_budget = 32'000, e.fine_samples = 3, e.truth_budget = 16'000;
  e.timing_size = e.yarn_timing_size = e.frame_size = 32, e.timing_repeats = 3, e.timing_enough_ns = 2e7;
  e.pans = 3;
  e.min_patch_pixels = 12, e.patch_yarns = 4, e.tube_facets = 24;
  e.fibre_pixels = 16, e.fibre_footprints = 1;
  e.drape_width = 24, e.drape_height = 8, e.drape_rays = 4000, e.drape_footprints = 1;
  e.drape_timing_size = e.drape_yarn_timing_size = 24;
  return e;
}

int patch_pixels(double yarns_per_pixel, const ChartEffort& effort) {
  return std::max(effort.min_patch_pixels, static_cast<int>(std::lround(effort.patch_yarns / yarns_per_pixel)));
}

FineGrid fine_grid(double view_deg, double yarns_per_pixel, const ChartEffort& effort) {
  constexpr int kMin = 32, kMinPixels = 4;
  FineGrid grid;
  const double across = yarns_per_pixel * effort.samples_per_yarn;
  grid.nx = std::max(kMin, static_cast<int>(std::ceil(across)));
  grid.ny = std::max(kMin, static_cast<int>(std::ceil(across / std::cos(radians(view_deg)))));
  const double fits = std::sqrt(static_cast<double>(effort.fine_budget) / (static_cast<double>(grid.nx) * grid.ny));
  grid.pixels = std::clamp(static_cast<int>(fits), kMinPixels, patch_pixels(yarns_per_pixel, effort));
  return grid;
}

}  // namespace weftlight::chart
