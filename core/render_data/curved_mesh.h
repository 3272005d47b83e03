#pragma once
// Shipped drapes have edges of 5 to 10 mm. At a fold, their flat triangles show in the outline and as saw teeth in the
// shadow of the fold on itself. For drawing, edges along which the surface turns are split, and their middles lifted to
// the curved surface.

#include <vector>

#include "render_data/ambient.h"

namespace weftlight::render_data {

/// Appends the middles of split edges to mesh and sky, and makes `fine` of the smaller triangles; mesh.index stays. The
/// two sides of a seam stay together where their vertices share normals, as those of shipped drapes do.
///
/// Based on: Vlachos, Peters, Boyd, Mitchell 2001, "Curved PN triangles" (the edges' cubic curves).
void split_curved_edges(PreparedMesh& prepared);

}  // namespace weftlight::render_data
