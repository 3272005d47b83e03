#pragma once
// The tile of a set: whole repeats, as many as its yarns need to show their variation. What hardly differs from repeat
// to repeat is measured on a few of them, so that the cost of a large tile is that of its texels.

#include <optional>

#include "cloth/cloth.h"
#include "design/design.h"

namespace weftlight::texture_set {

using cloth::Cloth;
using design::Design;
using draft::BitMatrix, draft::Face;

/// As the least side of a tile: several centimetres for yarns with slubs, melange or unevenness, else one repeat.
inline constexpr float kTileOfYarns = -1;

/// A face of the tile, with the twist of the images (those of the back are mirrored).
struct Tile {
  Cloth cloth;
  int across = 1, up = 1;  // repeats in it
  // A few repeats, on which far-field properties and occlusion are measured; none: the tile itself is small enough.
  std::optional<Cloth> part{};
  int part_across = 1, part_up = 1;  // repeats in that
};

/// Several repeats in both directions as one period; the irregularities of the yarns differ between them.
Cloth tiled(const Cloth& cloth, int across, int up);

/// Least side of the tile in mm for kTileOfYarns, if images have `size` texels on the longer side; 0: one repeat. Six
/// texels a thread remain, and it is 50 mm at most.
float tile_mm_for(const Cloth& repeat, int size);

/// cells: the drawdown, which has threads. tile_mm: least side; 0: one repeat; or kTileOfYarns, with the `size` of
/// tile_mm_for(). At most 8192 threads per system.
Tile make_tile(const Design& design, const BitMatrix& cells, Face face, float tile_mm, int size);

}  // namespace weftlight::texture_set
