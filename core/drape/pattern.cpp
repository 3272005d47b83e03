#include "drape/pattern.h"

#include <algorithm>

#include "drape/vec.h"

namespace weftlight::drape {

namespace {

/// Two triangles per cell; diagonals alternate like a chequerboard, so that folds prefer neither bias direction.
void append_cells(std::vector<uint32_t>& index, const Piece& piece) {
  for (int row = 0; row + 1 < piece.rows; ++row) {
    for (int column = 0; column + 1 < piece.columns; ++column) {
      const uint32_t a = piece.vertex(column, row), b = piece.vertex(column + 1, row);
      const uint32_t c = piece.vertex(column + 1, row + 1), d = piece.vertex(column, row + 1);
      const bool rising = (row + column) % 2 == 0;
      const auto corners = rising ? std::array{a, b, c, a, c, d} : std::array{a, b, d, b, c, d};
      index.insert(index.end(), corners.begin(), corners.end());
    }
  }
}

}  // namespace

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
  append_cells(pattern.index, piece);
  pattern.firmness.resize(pattern.index.size() / 3, 1);
  return piece;
}

void interline(Pattern& pattern, const Piece& piece, std::array<int, 2> columns, std::array<int, 2> rows,
               float firmness) {
  const auto is_in = [&](uint32_t vertex) {
    if (vertex < piece.first || vertex >= piece.vertex(0, piece.rows)) return false;
    const int at = static_cast<int>(vertex - piece.first), column = at % piece.columns, row = at / piece.columns;
    return column >= columns[0] && column <= columns[1] && row >= rows[0] && row <= rows[1];
  };
  for (size_t t = 0; t < pattern.firmness.size(); ++t) {
    const uint32_t* v = &pattern.index[3 * t];
    if (is_in(v[0]) && is_in(v[1]) && is_in(v[2])) pattern.firmness[t] = firmness;
  }
}

Vec2 grid_at(const Pattern& pattern, const Piece& piece, Vec2 uv) {
  Vec2 at{0.5f * static_cast<float>(piece.columns), 0.5f * static_cast<float>(piece.rows)};
  for (int pass = 0; pass < 12; ++pass) {
    const int column = std::clamp(static_cast<int>(at[0]), 0, piece.columns - 2);
    const int row = std::clamp(static_cast<int>(at[1]), 0, piece.rows - 2);
    const Vec2 corner = pattern.uv_mm[piece.vertex(column, row)];
    const Vec2 along = pattern.uv_mm[piece.vertex(column + 1, row)] - corner;
    const Vec2 up = pattern.uv_mm[piece.vertex(column, row + 1)] - corner, to = uv - corner;
    const float area = along[0] * up[1] - along[1] * up[0];
    at = {static_cast<float>(column) + (to[0] * up[1] - to[1] * up[0]) / area,
          static_cast<float>(row) + (along[0] * to[1] - along[1] * to[0]) / area};
  }
  return at;
}

void add_layer(Pattern& pattern, const Piece& piece, int columns, int rows, const LayerShape& shape, bool turned) {
  const Piece layer{static_cast<uint32_t>(pattern.layer_vertices.size()), columns, rows};
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const LayerPoint at = shape(i, j);
      const int column = std::clamp(static_cast<int>(at.column), 0, piece.columns - 2);
      const int row = std::clamp(static_cast<int>(at.row), 0, piece.rows - 2);
      const float s = at.column - static_cast<float>(column), t = at.row - static_cast<float>(row);
      LayerVertex v{{piece.vertex(column, row), piece.vertex(column + 1, row), piece.vertex(column, row + 1),
                     piece.vertex(column + 1, row + 1)},
                    {(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t},
                    at.lift_mm,
                    at.extra_mm};
      for (size_t k = 0; k < 4; ++k) v.uv_mm += v.weight[k] * pattern.uv_mm[v.under[k]];
      if (turned) v.uv_mm = {-v.uv_mm[1], v.uv_mm[0]};
      pattern.layer_vertices.push_back(v);
    }
  }
  append_cells(pattern.layer_index, layer);
}

float pattern_distance(const Pattern& pattern, uint32_t a, uint32_t b) {
  return length(pattern.uv_mm[a] - pattern.uv_mm[b]);
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
  for (const LayerVertex& v : pattern.layer_vertices) mesh.uv_mm.push_back(v.uv_mm);
  for (Vec2& uv : mesh.uv_mm) uv = {-uv[0], -uv[1]};  // end 1 at the right and pick 1 at the top of a hanging piece
  mesh.index = pattern.index;
  mesh.position_mm.reserve(mesh.uv_mm.size());
  for (const uint32_t particle : pattern.particle) mesh.position_mm.push_back(pattern.position_mm[particle]);
  compute_frames(mesh);
  if (pattern.layer_vertices.empty()) return mesh;
  const auto first = static_cast<uint32_t>(mesh.position_mm.size());
  for (const LayerVertex& v : pattern.layer_vertices) {
    Vec3 position{}, up{};
    for (size_t k = 0; k < 4; ++k) {
      position += v.weight[k] * mesh.position_mm[v.under[k]];
      up += v.weight[k] * mesh.normal[v.under[k]];
    }
    mesh.position_mm.push_back(position + v.lift_mm * unit(up));
  }
  for (const uint32_t v : pattern.layer_index) mesh.index.push_back(first + v);
  compute_frames(mesh);
  return mesh;
}

}  // namespace weftlight::drape
