#pragma once
// A simple mesh of known size.

#include "drape/mesh.h"

namespace weftlight::drape {

/// 200 x 100 mm, two triangles facing +z, u along x and v along y.
inline Mesh sheet() {
  Mesh mesh;
  mesh.name = "sheet";
  mesh.position_mm = {{0, 0, 0}, {200, 0, 0}, {200, 100, 0}, {0, 100, 0}};
  mesh.uv_mm = {{0, 0}, {200, 0}, {200, 100}, {0, 100}};
  mesh.index = {0, 1, 2, 0, 2, 3};
  compute_frames(mesh);
  return mesh;
}

}  // namespace weftlight::drape
