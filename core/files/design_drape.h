#pragma once
// The drape of a design, for the stiffness that its yarns and sett give: the limp, medium or stiff version of a shipped
// drape, or one simulated for this fabric and kept in the user's cache (cache_folder()/drapes).

#include <functional>
#include <string>

#include "files/files.h"

namespace weftlight::files {

using design::Design;
using drape::Mesh;

/// Like load_drape() of the scene's mesh. A shipped drape is taken in the version for the fabric
/// (presets/meshes/NAME.glb, NAME_limp.glb, NAME_stiff.glb); the simulated drape if the scene asks for it and it is in
/// the cache. A shipped drape whose file is missing or broken is simulated; of a lack of memory the error (kMemory) is
/// returned.
base::Result<Mesh> load_design_drape(const Design& design);
/// The same for an engine: the diagonals of a shipped drape run along its folds, as in our pictures. A mesh file keeps
/// its triangles.
base::Result<Mesh> load_worn_drape(const Design& design);
/// A key that is equal for designs with the same mesh; it changes when the simulated drape enters the cache.
std::string drape_key(const Design& design);

/// Whether the scene's drape can be simulated: all shipped ones except the plane.
bool can_drape(const Design& design);
/// Path of the simulated drape in the cache, existing or not; empty if the drape cannot be simulated.
std::string kept_drape_path(const Design& design);
/// Whether the cache holds a valid one. Reads the whole file.
bool is_draped(const Design& design);
/// Simulates the drape of this fabric, in seconds; empty if it cannot be simulated. `keep_going`: see
/// drape::simulate_drape().
Mesh simulate_design_drape(const Design& design, const std::function<bool(double progress)>& keep_going = {});
/// The same, into the cache, which drops its oldest files. Stopped it writes nothing, without an error.
base::Result<void> drape_cloth(const Design& design, const std::function<bool(double progress)>& keep_going = {});

}  // namespace weftlight::files
