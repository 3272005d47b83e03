#include "files/design_drape.h"

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>

#include "analysis/handle.h"
#include "base/resources.h"
#include "base/text.h"
#include "base/user_folders.h"
#include "base/whole_files.h"
#include "drape/stiffness.h"
#include "files/fabric_physics.h"
#include "platform/shipped_file.h"

namespace weftlight::files {

using base::ErrorKind, base::Result, base::arg, base::cache_folder, base::cause_of, base::failure, base::fill,
    base::keep_newest, base::presets_dir, base::tr;
using drape::DrapeParameters, drape::Vec2, drape::drape_file, drape::drape_names, drape::drape_parameters,
    drape::drape_stiffness_of, drape::simulate_drape, drape::turn_diagonals;

namespace {

namespace fs = std::filesystem;
constexpr size_t kMaxCached = 48;  // files of half a megabyte

bool is_shipped_drape(const Design& design) {
  const auto& shipped = drape_names();
  return std::find(shipped.begin(), shipped.end(), design.scene.mesh) != shipped.end();
}

/// Name, without extension, of the shipped version for the fabric.
std::string shipped_file(const Design& design) {
  return drape_file(design.scene.mesh, drape_stiffness_of(analysis::cloth_handle(design).bending_length_mm));
}

std::string shipped_path(const std::string& file) {
  return (fs::path(presets_dir()) / "meshes" / (file + ".glb")).string();
}

Result<Mesh> load_shipped(const Design& design) {
  const std::string& name = design.scene.mesh;
  const std::string file = can_drape(design) ? shipped_file(design) : name, path = shipped_path(file);
  if (file == name || !platform::is_shipped(path)) return load_drape(name);
  return read_mesh(path);
}

/// Loads the cached drape. A file in the cache may be old or foreign: it must have the pattern of the shipped drape.
Result<Mesh> load_cached(const Design& design) {
  const std::string path = kept_drape_path(design);
  std::error_code ec;
  if (path.empty() || !fs::exists(path, ec)) return failure(ErrorKind::kInput, tr("no such file"), path);
  Result<Mesh> cached = read_mesh(path);
  if (!cached) return cached;
  Result<Mesh> shipped = load_drape(design.scene.mesh);
  if (!shipped) return shipped;
  const auto near = [](Vec2 a, Vec2 b) { return glm::distance(a, b) < 0.01f; };
  const bool same = cached->index == shipped->index && std::ranges::equal(cached->uv_mm, shipped->uv_mm, near);
  if (!same) return failure(ErrorKind::kInput, tr("is not a mesh of this drape; it is simulated again"), path);
  return cached;
}

DrapeParameters drape_parameters_of(const Design& design) {
  const analysis::ClothHandle handle = analysis::cloth_handle(design);
  return drape_parameters(handle.bending_length_mm, handle.thickness_mm);
}

}  // namespace

FabricPhysics fabric_physics(const Design& design) {
  const analysis::ClothHandle handle = analysis::cloth_handle(design);
  if (!(handle.kg_per_m2 > 0)) return {};
  drape::Fabric fabric;
  drape::Fall fall;
  apply_parameters(fabric, fall, drape_parameters(handle.bending_length_mm, handle.thickness_mm));
  return {handle.kg_per_m2,         handle.thickness_mm,   handle.bending_n_m,
          handle.bending_length_mm, fabric.thread_n_per_m, fabric.bias_n_per_m};
}

bool can_drape(const Design& design) { return design.scene.mesh != "plane" && is_shipped_drape(design); }

std::string kept_drape_path(const Design& design) {
  if (!can_drape(design)) return {};
  const std::string file = drape_file(design.scene.mesh, drape_parameters_of(design)) + ".glb";
  return (fs::path(cache_folder()) / "drapes" / file).string();
}

bool is_draped(const Design& design) { return load_cached(design).has_value(); }

Mesh simulate_design_drape(const Design& design, const std::function<bool(double progress)>& keep_going) {
  return can_drape(design) ? simulate_drape(design.scene.mesh, drape_parameters_of(design), keep_going) : Mesh{};
}

Result<void> drape_cloth(const Design& design, const std::function<bool(double progress)>& keep_going) {
  const std::string path = kept_drape_path(design);
  if (path.empty()) return {};
  const fs::path folder = fs::path(path).parent_path();
  std::error_code ec;
  fs::create_directories(folder, ec);
  if (ec)
    return failure(ErrorKind::kOutput, fill(tr("{folder}: the folder cannot be created: {cause}"),
                                            arg("folder", folder.string()), arg("cause", cause_of(ec))));
  const Mesh mesh = simulate_design_drape(design, keep_going);
  if (mesh.position_mm.empty()) return {};
  Result<void> kept = write_mesh(path, mesh, nullptr);
  if (kept) keep_newest(folder.string(), ".glb", kMaxCached, path);
  return kept;
}

std::string drape_key(const Design& design) {
  if (!can_drape(design)) return design.scene.mesh;
  if (design.scene.simulated_drape) {
    // With its time: a broken file may have been replaced.
    const std::string path = kept_drape_path(design);
    std::error_code ec;
    const auto written = fs::last_write_time(path, ec);
    if (!ec) return path + "@" + std::to_string(static_cast<int64_t>(written.time_since_epoch().count()));
  }
  return shipped_file(design);
}

Result<Mesh> load_design_drape(const Design& design) {
  // A file for which there was no memory is not bad: it can be read again later.
  const auto is_bad = [](const Result<Mesh>& read) { return !read && read.error().kind != ErrorKind::kMemory; };
  Result<Mesh> read = design.scene.simulated_drape ? load_cached(design) : load_shipped(design);
  if (design.scene.simulated_drape && is_bad(read)) read = load_shipped(design);
  if (is_bad(read) && is_shipped_drape(design)) read = simulate_drape(design.scene.mesh);
  // The name selects the body, which does not depend on the stiffness.
  if (read && can_drape(design)) read->name = design.scene.mesh;
  return read;
}

Result<Mesh> load_worn_drape(const Design& design) {
  Result<Mesh> read = load_design_drape(design);
  if (read && can_drape(design)) turn_diagonals(*read);
  return read;
}

}  // namespace weftlight::files
