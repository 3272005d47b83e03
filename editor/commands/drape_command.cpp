// `drape`: simulated drapes as meshes.

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "base/file_names.h"
#include "base/text.h"
#include "base/whole_files.h"
#include "commands/commands.h"
#include "commands/open_design.h"
#include "commands/status_line.h"
#include "drape/stiffness.h"
#include "files/design_drape.h"
#include "files/files.h"

namespace weftlight::commands {

using base::arg, base::cause_of, base::fill, base::tr;
using design::Design;
using drape::DrapeStiffness, drape::Mesh, drape::body_mesh, drape::drape_file, drape::drape_names,
    drape::kDrapeStiffnessNames, drape::kDrapeStiffnesses, drape::simulate_drape;
using files::can_drape, files::is_draped, files::load_design_drape, files::simulate_design_drape, files::write_mesh;

namespace {

int write_one(const Mesh& mesh, const std::string& path) {
  if (const auto saved = write_mesh(path, mesh, nullptr); !saved) return fail(saved.error());
  const std::string line = fill(tr("{file}: {vertices} vertices, {triangles} triangles"), arg("file", path),
                                arg("vertices", mesh.position_mm.size()), arg("triangles", mesh.index.size() / 3));
  std::printf("%s\n", line.c_str());
  return kDone;
}

DrapeStiffness stiffness_from_name(const std::string& name) {
  for (const DrapeStiffness stiffness : kDrapeStiffnesses)
    if (name == kDrapeStiffnessNames[static_cast<size_t>(stiffness)]) return stiffness;
  return DrapeStiffness::kMedium;
}

/// Writes NAME.glb and, if the drape has a body, NAME_body.glb beside it.
int write_drape(const std::string& name, const Mesh& mesh, const std::filesystem::path& path) {
  if (const int exit = write_one(mesh, path.string()); exit != kDone) return exit;
  const Mesh body = body_mesh(name);
  if (body.position_mm.empty()) return kDone;
  const std::string beside = path.stem().string() + "_body" + path.extension().string();
  return write_one(body, (path.parent_path() / beside).string());
}

bool is_drape_name(const std::string& name) {
  const std::vector<std::string>& names = drape_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Refuses a name; `form` is the sentence, with the names of the drapes from `first` on.
int refuse_name(const std::string& name, const char* form, size_t first) {
  const std::vector<std::string>& all = drape_names();
  std::string names;
  for (size_t i = first; i < all.size(); ++i) names.append(names.empty() ? "" : ", ").append(all[i]);
  return refuse(fill(form, arg("name", name), arg("names", names)));
}

/// The drape of this fabric from the cache, or simulated.
Mesh simulated_mesh(Design& design) {
  design.scene.simulated_drape = true;
  if (is_draped(design)) return load_design_drape(design).value_or(Mesh{});
  StatusLine status;
  Mesh mesh = simulate_design_drape(design, [&status](double done) {
    status.show(fill(tr("simulating the drape: {percent}%"), arg("percent", static_cast<int>(100 * done))));
    return true;
  });
  status.clear();
  return mesh;
}

/// Writes the drape of a draft, simulated with its own yarns and sett.
int write_design_drape(const DrapeOptions& options) {
  if (!options.stiffness.empty())
    return refuse(tr("--stiffness is for a generic fabric; a draft is simulated with its own yarns and sett"));
  if (!options.mesh.empty() && (!is_drape_name(options.mesh) || options.mesh == "plane"))
    return refuse_name(options.mesh, tr("--mesh {name}: a fabric is draped as one of {names}"), 1);  // not on the plane
  OpenedDesign opened = open_design(options.name);
  if (!opened.ok) return kBadInput;
  Design& design = opened.design;
  if (!options.mesh.empty()) design.scene.mesh = options.mesh;
  if (!can_drape(design))
    return refuse(fill(tr("{file}: the mesh of its scene, {mesh}, cannot be simulated; give --mesh"),
                       arg("file", options.name), arg("mesh", design.scene.mesh)));
  if (const auto place = base::check_writable(options.out); !place) return fail(place.error());
  return write_drape(design.scene.mesh, simulated_mesh(design), options.out);
}

int write_named(const DrapeOptions& options) {
  const std::filesystem::path name(options.name);
  std::error_code ec;
  const bool known = is_drape_name(options.name);
  if (!known && !name.has_extension() && !std::filesystem::exists(name, ec))
    return refuse_name(options.name,
                       tr("no drape is called '{name}'; give one of {names}, all, or the path of a draft"), 0);
  const std::string extension = base::extension_of(options.out);
  if (extension != ".glb" && extension != ".gltf")
    return refuse(fill(tr("{file}: a drape is written as .glb or .gltf"), arg("file", options.out)));
  if (!known) return write_design_drape(options);
  if (!options.mesh.empty())
    return refuse(fill(tr("--mesh is for a draft; {name} is a drape itself"), arg("name", options.name)));
  return write_drape(options.name, simulate_drape(options.name, stiffness_from_name(options.stiffness)), options.out);
}

}  // namespace

int drape_command(const DrapeOptions& options) {
  if (options.name != "all") return write_named(options);
  std::error_code problem;
  std::filesystem::create_directories(options.out, problem);
  if (problem) {
    return fail({base::ErrorKind::kOutput, fill(tr("{folder}: the folder cannot be created: {cause}"),
                                                arg("folder", options.out), arg("cause", cause_of(problem)))});
  }
  for (const std::string& name : drape_names()) {
    const std::filesystem::path folder(options.out);
    if (const int exit = write_drape(name, simulate_drape(name), folder / (name + ".glb")); exit != kDone) return exit;
    for (const DrapeStiffness stiffness : {DrapeStiffness::kLimp, DrapeStiffness::kStiff}) {
      // The plane has no stiffness. The bodies are written already.
      if (drape_file(name, stiffness) == name) continue;
      const int exit =
          write_one(simulate_drape(name, stiffness), (folder / (drape_file(name, stiffness) + ".glb")).string());
      if (exit != kDone) return exit;
    }
  }
  return kDone;
}

}  // namespace weftlight::commands
