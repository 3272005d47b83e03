#pragma once
// Views of the cloth by name: some that every draft has, and those that are kept with it.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "draft/design.h"
#include "render_data/names.h"

namespace weftlight::render_data {

/// The drape of a flat swatch.
inline constexpr const char* kFlatMesh = "plane";

struct ShippedView {
  const char *id, *label;
};
inline constexpr std::array kShippedViews = {ShippedView{"whole", "Whole drape"}, ShippedView{"head_on", "Head on"},
                                             ShippedView{"grazing", "Grazing"}, ShippedView{"near", "Near threads"}};

/// View distance at which a flat swatch, seen straight on, fills a picture of so many pixels with threads so many
/// pixels wide, or with its whole height where they would be wider than it has.
float flat_distance(const Design& design, float width_px, float height_px, float pixels_a_yarn);

/// One of kShippedViews, for a picture of so many pixels; what hangs and how strong its light is stays the design's.
NamedView shipped_view(const Design& design, size_t which, float width_px, float height_px);

/// The same scene with its key light low from the side, which shows every thread's relief.
Scene lit_grazing(Scene scene);

/// By its name, whatever the case: those of the design first, then the shipped ones by id or label.
std::optional<NamedView> view_named(const Design& design, std::string_view name, float width_px, float height_px);
/// What can be asked for: the labels of the shipped ones, the names of the kept.
std::vector<std::string> view_names(const Design& design);

/// The scene that is drawn: of a flat view the swatch hangs instead of the mesh.
Scene drawn_scene(const NamedView& view);

}  // namespace weftlight::render_data
