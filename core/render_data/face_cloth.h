#pragma once
// The cloth of one face as it is drawn: which period of the draft, and how many texels its maps have.

#include "cloth/cloth.h"
#include "cloth/maps.h"
#include "design/design.h"
#include "draft/drawdown.h"

namespace weftlight::render_data {

using cloth::Cloth, cloth::Maps, cloth::MapsSize, cloth::Period, cloth::TexelRect;
using design::Design;
using draft::BitMatrix, draft::Face;

/// Whether its yarns are so uneven that a repeat of a few threads is not representative.
bool is_uneven(const Design& design);
/// The period of the maps: the whole draft if its threads get enough texels, else one repeat.
Period choose_period(const Design& design, const BitMatrix& cells);

/// The cloth of one face. The back is mapped in the front's (u, v) and seen mirrored, so the twist of its yarns is
/// reversed there, to be the same in space.
Cloth face_cloth(const Design& design, const BitMatrix& cells, Face face, Period period);
/// Whether two cloths differ at most in their crossings, so that maps of one can be updated to the other.
bool same_layout(const Cloth& a, const Cloth& b);

/// Sides are powers of two, so that every mip averages whole texels. `shadows`: with the shadow maps of vrst03.
MapsSize maps_size(const Cloth& cloth, bool shadows);
/// The same for a quick bake.
MapsSize quick_maps_size(const Cloth& cloth, bool shadows);
/// Quick bake of a window: where a texel holds many threads, some represent all.
Maps bake_quick(const Cloth& cloth, const MapsSize& size, const TexelRect& window);

}  // namespace weftlight::render_data
