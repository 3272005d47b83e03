#include "drape/pattern.h"

#include <algorithm>

#include "drape/vec.h"

namespace weftlight::drape {

Piece add_piece(Pattern& pattern, int columns, int rows, const PatternShape& shape, const Placement& place) {
  const Piece piece{static_cast<uint32_t>(pattern.uv_mm.size()), columns, rows};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Vec2 uv = shape(static_cast<float>(column) / static_cast<float>(columns - 1),
                            static_cast<float>(row) / static_cast<float>(rows - 1));
      pattern.uv_mm.push_back(uv);
      pattern.particle.push_back(static_cast<uint32_t>(pattern.position_mm.size()));
      pattern.position_mm.push_back(place(uv));
    }
  }
  // Diagonals alternate like a chequerboard, so that folds prefer neither bias.
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column + 1 < columns; ++column) {
      const uint32_t a = piece.vertex(column, row), b = piece.vertex(column + 1, row);
      const uint32_t c = piece.vertex(column + 1, row + 1), d = piece.vertex(column, row + 1);
      const bool rising = (row + column) % 2 == 0;
      const auto corners = rising ? std::array{a, b, c, a, c, d} : std::array{a, b, d, b, c, d};
      pattern.index.insert(pattern.index.end(), corners.begin(), corners.end());
    }
  }
  return piece;
}

void sew(Pattern& pattern, uint32_t a, uint32_t b) {
  const uint32_t kept = pattern.particle[a], gone = pattern.particle[b];
  std::replace(pattern.particle.begin(), pattern.particle.end(), gone, kept);
}

void drop_unused_particles(Pattern& pattern) {
  constexpr uint32_t kUnused = ~0u;
  std::vector<uint32_t> renumbered(pattern.position_mm.size(), kUnused);
  std::vector<Vec3> kept;
  for (uint32_t& particle : pattern.particle) {
    if (renumbered[particle] == kUnused) {
      renumbered[particle] = static_cast<uint32_t>(kept.size());
      kept.push_back(pattern.position_mm[particle]);
    }
    particle = renumbered[particle];
  }
  pattern.position_mm = std::move(kept);
}

Mesh to_mesh(const Pattern& pattern, const std::string& name) {
  Mesh mesh;
  mesh.name = name;
  mesh.uv_mm = pattern.uv_mm;
  for (Vec2& uv : mesh.uv_mm) uv = {-uv[0], -uv[1]};  // end 1 at the right and pick 1 at the top of a hanging piece
  mesh.index = pattern.index;
  mesh.position_mm.reserve(pattern.particle.size());
  for (const uint32_t particle : pattern.particle) mesh.position_mm.push_back(pattern.position_mm[particle]);
  compute_frames(mesh);
  return mesh;
}

}  // namespace weftlight::drape
