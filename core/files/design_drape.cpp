#include "files/design_drape.h"

#include <algorithm>
#include <filesystem>

#include "analysis/hand.h"
#include "base/resources.h"
#include "drape/hang.h"

namespace weftlight::files {

std::string drape_key(const Design& design) {
  const std::string& name = design.scene.mesh;
  const auto& shipped = drape_names();
  if (std::find(shipped.begin(), shipped.end(), name) == shipped.end()) return name;
  return drape_file(name, hang_of(analysis::cloth_hand(design).bending_length_mm));
}

ReadMesh load_design_drape(const Design& design) {
  const std::string key = drape_key(design);
  const std::filesystem::path path = std::filesystem::path(presets_dir()) / "meshes" / (key + ".glb");
  std::error_code ec;
  if (key == design.scene.mesh || !std::filesystem::exists(path, ec)) return load_drape(design.scene.mesh);
  ReadMesh read = read_mesh(path.string());
  // Its form is that of the drape, however the cloth hangs.
  if (read.mesh) read.mesh->name = design.scene.mesh;
  return read;
}

}  // namespace weftlight::files
