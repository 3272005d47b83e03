#pragma once
// Named views of the cloth: those that every draft has, and those kept with it.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "design/design.h"

namespace weftlight::scene {

using design::Design, design::NamedView, design::Scene;

/// The drape of a flat swatch.
inline constexpr const char* kFlatMesh = "plane";

struct ShippedView {
  const char *id, *label;  // label: to be shown through base::tr()
};
inline constexpr std::array kShippedViews = {
    ShippedView{"whole", base::mark("Whole drape")}, ShippedView{"head_on", base::mark("Head on")},
    ShippedView{"grazing", base::mark("Grazing")}, ShippedView{"near", base::mark("Near threads")}};

/// View distance at which a flat swatch, seen straight on, fills a picture with threads of the given width in pixels,
/// or is shown at its full height if that would be wider.
float flat_distance(const Design& design, float width_px, float height_px, float pixels_a_yarn);

/// Size of a pixel on the flat swatch, at the centre of a picture of this size.
float flat_pixel_mm(const Scene& scene, int width_px, int height_px);
/// The view distance at which that is `pixel_mm`.
float flat_distance_of_pixel(float pixel_mm, int width_px, int height_px);
/// The point of the swatch at the centre of the picture, from its lower left corner. Seen straight on.
struct SwatchPoint {
  float x_mm = 0, y_mm = 0;
};
SwatchPoint flat_centre(const Scene& scene, int width_px, int height_px);
/// Sizes of the swatch.
inline constexpr float kFlatWidth_mm = 300, kFlatHeight_mm = 200;

/// One of kShippedViews, for a picture of this size; mesh and light strength stay the design's.
NamedView shipped_view(const Design& design, size_t which, float width_px, float height_px);

/// The same scene with its key light low from the side, which shows the relief of the threads.
Scene lit_grazing(Scene scene);

/// Finds a view by name, case-insensitive: first those of the design, then the shipped ones by id or label.
std::optional<NamedView> view_named(const Design& design, std::string_view name, float width_px, float height_px);
/// All view names: labels of the shipped ones, names of the kept ones.
std::vector<std::string> view_names(const Design& design);

/// The scene to draw: a flat view has the swatch as its mesh.
Scene drawn_scene(const NamedView& view);

}  // namespace weftlight::scene
