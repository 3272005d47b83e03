#pragma once
// Second layers on a garment (placket, facing, hem, pocket, button): strips with turned edges and stitches.

#include <vector>

#include "drape/names.h"
#include "drape/pattern.h"
#include "drape/vec.h"

namespace weftlight::drape {

/// A place across a layer and how much of its thickness it has there: turned edges, a seam's groove beside them.
struct Knot {
  float at_mm, thick;
  float more_mm = 0;  // of cloth, as it goes up and down on its way from the middle
};

/// From `from` to `to`, stitched that far from its edges (0: not at all), in steps of about step_mm.
std::vector<Knot> knots(float from, float to, float stitch_from, float stitch_to, float step_mm);

using LayerGrid = std::function<Vec2(float across, float along)>;
/// Lays a strip on: across and along in mm, put into the piece's columns and rows by `grid`.
void lay_strip(Pattern& pattern, const Piece& piece, const std::vector<Knot>& across, const std::vector<Knot>& along,
               const LayerGrid& grid, bool turned = false);

/// A button covered with the cloth, about a place of the piece, on a layer or two.
void lay_button(Pattern& pattern, const Piece& piece, Vec2 uv_mm);

}  // namespace weftlight::drape
