#pragma once
// The drape that a design is shown on, as a cloth of its yarns and its sett hangs.

#include <string>

#include "files/files.h"
#include "files/names.h"

namespace weftlight::files {

/// As load_drape() of the scene's mesh; of a shipped drape the limper or stiffer one where the cloth is so
/// (presets/meshes/NAME_limp.glb, NAME_stiff.glb).
ReadMesh load_design_drape(const Design& design);
/// The same for designs that get the same mesh.
std::string drape_key(const Design& design);

}  // namespace weftlight::files
