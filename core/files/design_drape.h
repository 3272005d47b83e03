#pragma once
// The drape that a design is shown on, as a cloth of its yarns and its sett hangs: one of the shipped three of its
// kind, or one simulated for this cloth alone, kept in the user's cache (cache_folder()/drapes).

#include <functional>
#include <string>

#include "files/files.h"
#include "files/names.h"

namespace weftlight::files {

/// As load_drape() of the scene's mesh; of a shipped drape the limper or stiffer one where the cloth is so
/// (presets/meshes/NAME_limp.glb, NAME_stiff.glb), or the cloth's own where the scene asks for it and it is kept.
ReadMesh load_design_drape(const Design& design);
/// The same for designs that get the same mesh; another once the cloth's own is kept.
std::string drape_key(const Design& design);

/// Whether the scene's drape is one that is simulated: a shipped one, but the plane.
bool can_drape(const Design& design);
/// Where the cloth's own drape is kept, whether it is there or not; empty where it has none.
std::string kept_drape_path(const Design& design);
/// Whether a good one is kept. Reads all of it.
bool is_draped(const Design& design);
/// The cloth's own drape, simulated (seconds); empty where it has none. `go_on` as of drape::simulate_drape().
Mesh simulate_design_drape(const Design& design, const std::function<bool(double share)>& go_on = {});
/// The same, kept; the oldest kept ones make room. Empty: done, or left; else what went wrong.
std::string drape_cloth(const Design& design, const std::function<bool(double share)>& go_on = {});

}  // namespace weftlight::files
