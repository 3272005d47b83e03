#include "files/design_drape.h"

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>

#include "analysis/handle.h"
#include "base/files.h"
#include "base/resources.h"
#include "base/user_folders.h"
#include "drape/stiffness.h"

namespace weftlight::files {
namespace {

namespace fs = std::filesystem;
constexpr size_t kMaxKept = 48;  // of half a megabyte each

/// Without the ending, of the three of its kind.
std::string shipped_file(const Design& design) {
  return drape_file(design.scene.mesh, drape_stiffness_of(analysis::cloth_handle(design).bending_length_mm));
}

std::string shipped_path(const std::string& file) {
  return (fs::path(presets_dir()) / "meshes" / (file + ".glb")).string();
}

ReadMesh load_shipped(const Design& design) {
  const std::string& name = design.scene.mesh;
  const std::string file = can_drape(design) ? shipped_file(design) : name, path = shipped_path(file);
  std::error_code ec;
  if (file == name || !fs::exists(path, ec)) return load_drape(name);
  return read_mesh(path);
}

/// What is kept may be of any age and from anywhere: it must have the pattern that the shipped one has.
ReadMesh load_kept(const Design& design) {
  const std::string path = kept_drape_path(design);
  std::error_code ec;
  if (path.empty() || !fs::exists(path, ec)) return {};
  ReadMesh kept = read_mesh(path);
  if (!kept.mesh) return kept;
  const ReadMesh shipped = load_drape(design.scene.mesh);
  const auto near = [](Vec2 a, Vec2 b) { return glm::distance(a, b) < 0.01f; };
  const bool same = shipped.mesh && kept.mesh->index == shipped.mesh->index &&
                    std::ranges::equal(kept.mesh->uv_mm, shipped.mesh->uv_mm, near);
  if (!same) return {{}, path + ": is no drape of this kind; it is simulated again"};
  return kept;
}

DrapeHandle own_hang_of(const Design& design) {
  const analysis::ClothHandle hand = analysis::cloth_handle(design);
  return drape_handle(hand.bending_length_mm, hand.thickness_mm);
}

}  // namespace

bool can_drape(const Design& design) {
  const auto& shipped = drape_names();
  return design.scene.mesh != "plane" && std::find(shipped.begin(), shipped.end(), design.scene.mesh) != shipped.end();
}

std::string kept_drape_path(const Design& design) {
  if (!can_drape(design)) return {};
  const std::string file = drape_file(design.scene.mesh, own_hang_of(design)) + ".glb";
  return (fs::path(cache_folder()) / "drapes" / file).string();
}

bool is_draped(const Design& design) { return load_kept(design).mesh.has_value(); }

Mesh simulate_design_drape(const Design& design, const std::function<bool(double share)>& go_on) {
  return can_drape(design) ? simulate_drape(design.scene.mesh, own_hang_of(design), go_on) : Mesh{};
}

std::string drape_cloth(const Design& design, const std::function<bool(double share)>& go_on) {
  const std::string path = kept_drape_path(design);
  if (path.empty()) return {};
  const fs::path folder = fs::path(path).parent_path();
  std::error_code ec;
  fs::create_directories(folder, ec);
  if (ec) return folder.string() + ": the folder cannot be made: " + cause_of(ec.value());
  const Mesh mesh = simulate_design_drape(design, go_on);
  if (mesh.position_mm.empty()) return {};
  std::string problem = write_mesh(path, mesh, nullptr);
  if (problem.empty()) keep_newest(folder.string(), ".glb", kMaxKept);
  return problem;
}

std::string drape_key(const Design& design) {
  if (!can_drape(design)) return design.scene.mesh;
  if (design.scene.simulated_drape) {
    // With its time: one that was broken may have been made anew.
    const std::string path = kept_drape_path(design);
    std::error_code ec;
    const auto written = fs::last_write_time(path, ec);
    if (!ec) return path + "@" + std::to_string(written.time_since_epoch().count());
  }
  return shipped_file(design);
}

ReadMesh load_design_drape(const Design& design) {
  ReadMesh read = design.scene.simulated_drape ? load_kept(design) : ReadMesh{};
  if (!read.mesh) read = load_shipped(design);
  // Its form is that of the drape, however the cloth hangs.
  if (read.mesh && can_drape(design)) read.mesh->name = design.scene.mesh;
  return read;
}

}  // namespace weftlight::files
