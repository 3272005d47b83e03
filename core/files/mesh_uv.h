#pragma once
// Meshes whose texture coordinates are not millimetres.

#include <string>

#include "files/files.h"

namespace weftlight::files {

struct MeshUv {
  bool millimetres = true;           // which the file says; read_mesh() believes it
  float offset_u = 0, offset_v = 0;  // KHR_texture_transform: added to the scaled coordinates, right and down
};

/// write_mesh() with coordinates of this kind in Mesh::uv_mm.
base::Result<void> write_mesh(const std::string& path, const Mesh& mesh, const GltfMaterial* front,
                              const GltfMaterial* back, const MeshUv& uv);

}  // namespace weftlight::files
