// Close pairs by a hashed grid, its cells as wide as the reach.
// Based on: Teschner et al., "Optimized Spatial Hashing for Collision Detection of Deformable
// Objects", VMV 2003 (the hash). Differs: cells are filled by a counting sort, so the order is fixed.

#include "drape/pairs.h"

#include <algorithm>

namespace weftlight::drape {

namespace {

constexpr uint32_t kCells = 1u << 14;

struct Cell {
  int x, y, z;
};

uint32_t hashed(Cell c) {
  return (static_cast<uint32_t>(c.x) * 73856093u ^ static_cast<uint32_t>(c.y) * 19349663u ^
          static_cast<uint32_t>(c.z) * 83492791u) &
         (kCells - 1);
}

Cell cell_of(Vec3d p, double width) {
  const auto number = [&](double x) { return static_cast<int>(std::floor(x / width)); };
  return {number(p[0]), number(p[1]), number(p[2])};
}

bool are_near(const SimulatedCloth& cloth, uint32_t a, uint32_t b) {
  return std::binary_search(cloth.near.begin() + cloth.near_first[a], cloth.near.begin() + cloth.near_first[a + 1], b);
}

/// Particles sorted by hashed cell; cell h has members[first[h]] .. members[first[h + 1]].
struct Grid {
  std::vector<uint32_t> first, members;
};

Grid sort_into_cells(const std::vector<Vec3d>& positions, double width) {
  Grid grid;
  grid.first.assign(kCells + 1, 0);
  grid.members.resize(positions.size());
  for (const Vec3d& p : positions) ++grid.first[hashed(cell_of(p, width)) + 1];
  for (uint32_t h = 0; h < kCells; ++h) grid.first[h + 1] += grid.first[h];
  std::vector<uint32_t> next(grid.first.begin(), grid.first.end() - 1);
  for (uint32_t i = 0; i < positions.size(); ++i) {
    grid.members[next[hashed(cell_of(positions[i], width))]++] = i;
  }
  return grid;
}

}  // namespace

void find_pairs(const SimulatedCloth& cloth, double reach_mm, std::vector<ParticlePair>& pairs) {
  pairs.clear();
  const Grid grid = sort_into_cells(cloth.position, reach_mm);
  std::array<uint32_t, 27> cells;
  for (uint32_t a = 0; a < cloth.position.size(); ++a) {
    const Cell c = cell_of(cloth.position[a], reach_mm);
    size_t count = 0;
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) cells[count++] = hashed({c.x + x, c.y + y, c.z + z});
      }
    }
    std::sort(cells.begin(), cells.end());
    const auto last = std::unique(cells.begin(), cells.end());
    for (auto h = cells.begin(); h != last; ++h) {
      for (uint32_t k = grid.first[*h]; k < grid.first[*h + 1]; ++k) {
        const uint32_t b = grid.members[k];
        if (b <= a) continue;
        const Vec3d d = cloth.position[b] - cloth.position[a];
        if (dot(d, d) < reach_mm * reach_mm && !are_near(cloth, a, b)) pairs.push_back({a, b});
      }
    }
  }
}

}  // namespace weftlight::drape
