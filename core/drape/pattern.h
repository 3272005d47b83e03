#pragma once
// A pattern: the flat pieces that a drape is cut from, gridded, and how they are sewn together.
// Vertices carry pattern coordinates; where pieces are sewn, vertices share a particle.

#include <functional>

#include "drape/mesh.h"
#include "drape/names.h"

namespace weftlight::drape {

struct Pattern {
  std::vector<Vec2> uv_mm;         // of a vertex, along weft and warp
  std::vector<uint32_t> particle;  // of a vertex: what moves it
  std::vector<uint32_t> index;     // three vertices a triangle, counter-clockwise in (u, v)
  std::vector<Vec3> position_mm;   // of a particle, where it starts
};

/// A gridded piece of a pattern: vertex(column, row), columns along s, rows along t.
struct Piece {
  uint32_t first = 0;
  int columns = 0, rows = 0;
  uint32_t vertex(int column, int row) const { return first + static_cast<uint32_t>(row * columns + column); }
};

using PatternShape = std::function<Vec2(float s, float t)>;  // s, t in 0..1 -> uv in mm
using Placement = std::function<Vec3(Vec2 uv_mm)>;

/// Adds a piece with a particle for each vertex. The shape keeps (s, t) right-handed.
Piece add_piece(Pattern& pattern, int columns, int rows, const PatternShape& shape, const Placement& place);

/// Sews vertex b to vertex a: they share a's particle from now on.
void sew(Pattern& pattern, uint32_t a, uint32_t b);

/// Drops the particles that sewing left without a vertex.
void drop_unused_particles(Pattern& pattern);

/// The mesh of a pattern, with frames.
Mesh to_mesh(const Pattern& pattern, const std::string& name);

}  // namespace weftlight::drape
