#pragma once
// Second layers on a garment (placket, facing, hem, pocket, button): strips with folded edges and stitches.

#include <vector>

#include "drape/pattern.h"
#include "drape/vec.h"

namespace weftlight::drape {

/// A point of the cross-section of a layer: folded edges, and the groove of a stitch line beside them.
struct ProfilePoint {
  float at_mm, thickness;  // thickness: fraction of the layer's
  float extra_mm = 0;      // extra length of cloth from the middle to here, as the surface goes up and down
};

/// The cross-section from `from` to `to` in steps of about step_mm, stitched at these distances from its edges (0: not
/// stitched). All in mm.
std::vector<ProfilePoint> strip_profile(float from, float to, float stitch_from, float stitch_to, float step_mm);

using LayerGrid = std::function<Vec2(float across, float along)>;
/// Adds a strip; `grid` maps across and along, in mm, to columns and rows of the piece.
void add_strip(Pattern& pattern, const Piece& piece, const std::vector<ProfilePoint>& across,
               const std::vector<ProfilePoint>& along, const LayerGrid& grid, bool turned = false);

/// Adds a fabric-covered button at a point of the pattern.
void add_button(Pattern& pattern, const Piece& piece, Vec2 uv_mm);

}  // namespace weftlight::drape
