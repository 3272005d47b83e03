#pragma once
// A pattern: the flat, gridded pieces of a drape, and how they are sewn together. Vertices have pattern coordinates; at
// a seam, vertices share a particle.

#include <array>
#include <functional>

#include "drape/mesh.h"

namespace weftlight::drape {

/// A vertex of a second layer (placket, pocket, button): interpolated between four vertices of the piece below, and
/// lifted.
struct LayerVertex {
  std::array<uint32_t, 4> under;
  std::array<float, 4> weight;
  float lift_mm;
  Vec2 uv_mm;
};

struct Pattern {
  std::vector<Vec2> uv_mm;                  // of a vertex, along weft and warp
  std::vector<uint32_t> particle;           // of a vertex
  std::vector<uint32_t> index;              // three vertices a triangle, counter-clockwise in (u, v)
  std::vector<float> firmness;              // of a triangle: factor on the bending stiffness; above 1: interlined
  std::vector<Vec3> position_mm;            // of a particle, at the start
  std::vector<LayerVertex> layer_vertices;  // second layers: drawn, not simulated
  std::vector<uint32_t> layer_index;
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

/// Sets the firmness of the cells between these columns and rows of vertices, ends included.
void interline(Pattern& pattern, const Piece& piece, std::array<int, 2> columns, std::array<int, 2> rows,
               float firmness);

/// Position of a layer vertex: in columns and rows of the piece below, and its lift. `extra_mm`: added to its pattern
/// coordinates, for cloth that goes up and down.
struct LayerPoint {
  float column, row, lift_mm;
  Vec2 extra_mm{};
};
/// The columns (x) and rows (y) of a piece at a point of its pattern.
Vec2 grid_at(const Pattern& pattern, const Piece& piece, Vec2 uv_mm);
using LayerShape = std::function<LayerPoint(int i, int j)>;
/// Adds a gridded layer of the same cloth on a piece; i and j are right-handed like its columns and rows. `turned`: cut
/// with its warp across that of the piece.
void add_layer(Pattern& pattern, const Piece& piece, int columns, int rows, const LayerShape& shape,
               bool turned = false);

/// Distance of two vertices of a piece in its pattern, mm.
float pattern_distance(const Pattern& pattern, uint32_t a, uint32_t b);

/// Sews vertex b to vertex a: from now on both have a's particle.
void sew(Pattern& pattern, uint32_t a, uint32_t b);

/// Drops the particles that sewing left without a vertex.
void drop_unused_particles(Pattern& pattern);

/// Removes waves as short as a cell from the positions of the particles: they are artefacts of the grid.
void smooth_cell_waves(Pattern& pattern, int passes);

/// The mesh of a pattern, with frames.
Mesh to_mesh(const Pattern& pattern, const std::string& name);

}  // namespace weftlight::drape
