#include "scene/named_views.h"

#include <algorithm>

#include "scene/camera.h"

namespace weftlight::scene {

using base::tr;
using draft::System, draft::Threads;

namespace {

enum Shipped : size_t { kWhole, kHeadOn, kGrazing, kNear };

constexpr float kHeadOnPixels = 9, kNearPixels = 42;  // pixels a yarn
// View and light on opposite sides of the normal, so that gloss along the cloth is visible.
constexpr float kGrazingView = 68, kGrazingLight = -72, kGrazingHeight = 12;  // degrees

/// Mean spacing of a system, mm.
float mean_spacing(const Design& design, System system) {
  const Threads& t = design.draft.threads(system);
  float sum = 0;
  for (size_t i = 0; i < t.color.size(); ++i)
    sum += t.spacing_mm[i] >= 0 ? t.spacing_mm[i] : design.yarns[static_cast<size_t>(t.yarn[i])].diameter_mm;
  return t.color.empty() ? 1 : sum / static_cast<float>(t.color.size());
}

bool same_name(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(a, b, {}, lower, lower);
}

const Bounds kSwatch{{-kFlatWidth_mm / 2, 0, 0}, {kFlatWidth_mm / 2, kFlatHeight_mm, 0}};

}  // namespace

float flat_pixel_mm(const Scene& scene, int width_px, int height_px) {
  return place_camera(scene, {}, kSwatch, std::max(1, width_px), std::max(1, height_px), 0, 0).pixel_mm;
}

float flat_distance_of_pixel(float pixel_mm, int width_px, int height_px) {
  Scene whole;  // what a pixel sees is in proportion to the distance
  whole.view_azimuth = whole.view_elevation = 0;
  whole.view_distance = 1;
  return pixel_mm / flat_pixel_mm(whole, width_px, height_px);
}

SwatchPoint flat_centre(const Scene& scene, int width_px, int height_px) {
  const float frame_mm = flat_pixel_mm(scene, width_px, height_px) * static_cast<float>(width_px);
  return {kFlatWidth_mm / 2 - scene.pan_x * frame_mm, kFlatHeight_mm / 2 - scene.pan_y * frame_mm};
}

float flat_distance(const Design& design, float width_px, float height_px, float pixels_a_yarn) {
  constexpr float kFilled = 0.96f;  // of the swatch, so that no edge is visible
  const float aspect = std::max(width_px, 1.0f) / std::max(height_px, 1.0f);
  const float spacing = 0.5f * (mean_spacing(design, System::kWarp) + mean_spacing(design, System::kWeft));
  const float most = kFilled * std::min(kFlatHeight_mm, kFlatWidth_mm / aspect);
  return distance_of_height(kSwatch, aspect, std::min(height_px / pixels_a_yarn * spacing, most));
}

NamedView shipped_view(const Design& design, size_t which, float width_px, float height_px) {
  NamedView view{tr(kShippedViews[which].label), design.scene, which != kWhole};
  Scene& s = view.scene;
  const Scene first;
  s.pan_x = s.pan_y = 0;
  s.view_azimuth = which == kWhole ? first.view_azimuth : which == kGrazing ? kGrazingView : 0;
  s.view_elevation = which == kWhole ? first.view_elevation : 0;
  s.view_distance =
      which == kWhole ? 1 : flat_distance(design, width_px, height_px, which == kNear ? kNearPixels : kHeadOnPixels);
  if (which == kGrazing) s = lit_grazing(s);
  return view;
}

Scene lit_grazing(Scene scene) {
  scene.light_azimuth = kGrazingLight;
  scene.light_elevation = kGrazingHeight;
  return scene;
}

std::optional<NamedView> view_named(const Design& design, std::string_view name, float width_px, float height_px) {
  for (const NamedView& view : design.views)
    if (same_name(view.name, name)) return view;
  for (size_t i = 0; i < kShippedViews.size(); ++i)
    if (same_name(kShippedViews[i].id, name) || same_name(tr(kShippedViews[i].label), name))
      return shipped_view(design, i, width_px, height_px);
  return {};
}

std::vector<std::string> view_names(const Design& design) {
  std::vector<std::string> names;
  for (const ShippedView& view : kShippedViews) names.emplace_back(tr(view.label));
  for (const NamedView& view : design.views) names.push_back(view.name);
  return names;
}

Scene drawn_scene(const NamedView& view) {
  Scene scene = view.scene;
  if (view.flat) scene.mesh = kFlatMesh;
  return scene;
}

}  // namespace weftlight::scene
