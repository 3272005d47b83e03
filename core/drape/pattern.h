#pragma once
// A pattern: the flat pieces that a drape is cut from, gridded, and how they are sewn together.
// Vertices carry pattern coordinates; where pieces are sewn, vertices share a particle.

#include <array>
#include <functional>

#include "drape/mesh.h"
#include "drape/names.h"

namespace weftlight::drape {

/// A vertex of a second layer (placket, pocket, button): between four vertices of what it lies on, and above it.
struct LaidVertex {
  std::array<uint32_t, 4> under;
  std::array<float, 4> share;
  float lift_mm;
  Vec2 uv_mm;
};

struct Pattern {
  std::vector<Vec2> uv_mm;         // of a vertex, along weft and warp
  std::vector<uint32_t> particle;  // of a vertex: what moves it
  std::vector<uint32_t> index;     // three vertices a triangle, counter-clockwise in (u, v)
  std::vector<float> firmness;     // of a triangle: share of the cloth's stiffness in bending; over 1: interlined
  std::vector<Vec3> position_mm;   // of a particle, where it starts
  std::vector<LaidVertex> laid;    // of layers on the cloth: drawn, and no part of the simulation
  std::vector<uint32_t> laid_index;
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

/// Makes the cells of a piece in those rows and columns (of vertices, both ends with them) as firm as that.
void interline(Pattern& pattern, const Piece& piece, std::array<int, 2> columns, std::array<int, 2> rows,
               float firmness);

/// Where a layer's vertex lies: in columns and rows of the piece under it, and above it. `more_mm`: of its pattern, for
/// what goes up and down.
struct LaidAt {
  float column, row, lift_mm;
  Vec2 more_mm{};
};
/// Where on a piece a place of its pattern is, in columns (x) and rows (y).
Vec2 grid_at(const Pattern& pattern, const Piece& piece, Vec2 uv_mm);
using LayerShape = std::function<LaidAt(int i, int j)>;
/// Lays a gridded layer of the same cloth on a piece, i and j right-handed as its columns and rows are. `turned`: cut
/// with its warp across that of the piece.
void lay_on(Pattern& pattern, const Piece& piece, int columns, int rows, const LayerShape& shape, bool turned = false);

/// Between two vertices of a piece, in its pattern, mm.
float apart(const Pattern& pattern, uint32_t a, uint32_t b);

/// Sews vertex b to vertex a: they share a's particle from now on.
void sew(Pattern& pattern, uint32_t a, uint32_t b);

/// Drops the particles that sewing left without a vertex.
void drop_unused_particles(Pattern& pattern);

/// Takes out of the particles' places the waves that are as short as a cell, which are the grid's and not the cloth's.
void iron(Pattern& pattern, int passes);

/// The mesh of a pattern, with frames.
Mesh to_mesh(const Pattern& pattern, const std::string& name);

}  // namespace weftlight::drape
