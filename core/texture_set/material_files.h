#pragma once
// The material that goes with the images: a .glb of the draped mesh, or the engine's own text file.

#include <string>

#include "drape/mesh.h"
#include "texture_set/names.h"
#include "texture_set/surface.h"
#include "texture_set/targets.h"

namespace weftlight::texture_set {

/// True where some texel is more gap than thread, so that the material needs an alpha test.
bool has_gaps(const Surface& surface);

/// True where the material comes with a mesh.
bool needs_mesh(Target target);

struct MaterialFile {
  std::string file;  // name inside the folder; empty when the target needs none
  std::string error;
};

/// Writes the material of the front face into `folder`.
MaterialFile write_material(const std::string& folder, const std::string& name, Target target, const Surface& surface,
                            const Mesh& mesh);

}  // namespace weftlight::texture_set
