#include <cstdio>
#include <filesystem>
#include <utility>

#include "base/files.h"
#include "commands/commands.h"
#include "commands/status_line.h"
#include "drape/stiffness.h"
#include "files/design_drape.h"
#include "files/files.h"

namespace weftlight::commands {

namespace {

int write_one(const Mesh& mesh, const std::string& path) {
  const std::string problem = write_mesh(path, mesh, nullptr);
  if (problem.empty()) {
    std::printf("%s: %zu vertices, %zu triangles\n", path.c_str(), mesh.position_mm.size(), mesh.index.size() / 3);
    return kDone;
  }
  return not_written(problem);
}

DrapeStiffness hang_called(const std::string& name) {
  for (const DrapeStiffness hang : kHangs)
    if (name == kHangNames[static_cast<size_t>(hang)]) return hang;
  return DrapeStiffness::kMedium;
}

/// NAME.glb and, where the drape lies on something, NAME_body.glb beside it.
int write_drape(const std::string& name, const Mesh& mesh, const std::filesystem::path& path) {
  if (const int exit = write_one(mesh, path.string()); exit != kDone) return exit;
  const Mesh body = body_mesh(name);
  if (body.position_mm.empty()) return kDone;
  const std::string beside = path.stem().string() + "_body" + path.extension().string();
  return write_one(body, (path.parent_path() / beside).string());
}

bool is_known(const std::string& name) {
  for (const std::string& known : drape_names()) {
    if (known == name) return true;
  }
  return false;
}

int refuse(const std::string& name, const char* first) {
  std::fprintf(stderr, "weftlight: no drape is called '%s'; there are: %s", name.c_str(), first);
  const char* between = "";
  for (const std::string& known : drape_names())
    std::fprintf(stderr, "%s%s", std::exchange(between, ", "), known.c_str());
  std::fprintf(stderr, "\n");
  return kUsage;
}

int usage(const std::string& what) {
  std::fprintf(stderr, "weftlight: %s\n", what.c_str());
  return kUsage;
}

/// The one that a picture kept, else simulated.
Mesh own_mesh(Design& design) {
  design.scene.simulated_drape = true;
  if (is_draped(design)) return load_design_drape(design).mesh.value_or(Mesh{});
  StatusLine status;
  Mesh mesh = simulate_design_drape(design, [&status](double share) {
    status.say("draping, " + std::to_string(static_cast<int>(100 * share)) + " %");
    return true;
  });
  status.clear();
  return mesh;
}

/// As the draft's own yarns and sett make it hang.
int write_own(const DrapeOptions& options) {
  if (!options.hang.empty()) return usage("--hang is of a shipped drape; a draft hangs as its cloth does");
  if (!options.mesh.empty() && (!is_known(options.mesh) || options.mesh == "plane")) return refuse(options.mesh, "");
  OpenedDesign opened = open_design(options.name);
  if (!opened.ok) return kBadInput;
  Design& design = opened.design;
  if (!options.mesh.empty()) design.scene.mesh = options.mesh;
  if (!can_drape(design))
    return usage(options.name + ": its scene's mesh, " + design.scene.mesh + ", is not one that falls; give --mesh");
  if (const std::string why = why_not_writable(options.out); !why.empty()) return not_written(why);
  return write_drape(design.scene.mesh, own_mesh(design), options.out);
}

int write_named(const DrapeOptions& options) {
  const std::filesystem::path name(options.name);
  std::error_code ec;
  const bool known = is_known(options.name);
  if (!known && !name.has_extension() && !std::filesystem::exists(name, ec)) return refuse(options.name, "all, ");
  const std::string extension = std::filesystem::path(options.out).extension().string();
  if (extension != ".glb" && extension != ".gltf") return usage(options.out + ": a drape is written as .glb or .gltf");
  if (!known) return write_own(options);
  if (!options.mesh.empty()) return usage("--mesh is of a draft; " + options.name + " is a drape itself");
  return write_drape(options.name, simulate_drape(options.name, hang_called(options.hang)), options.out);
}

}  // namespace

int drape_command(const DrapeOptions& options) {
  if (options.name != "all") return write_named(options);
  std::error_code problem;
  std::filesystem::create_directories(options.out, problem);
  if (problem) {
    std::fprintf(stderr, "%s: the folder cannot be made: %s\n", options.out.c_str(), cause_of(problem.value()).c_str());
    return kNotWritten;
  }
  for (const std::string& name : drape_names()) {
    const std::filesystem::path folder(options.out);
    if (const int exit = write_drape(name, simulate_drape(name), folder / (name + ".glb")); exit != kDone) return exit;
    for (const DrapeStiffness hang : {DrapeStiffness::kLimp, DrapeStiffness::kStiff}) {
      // The plane has one alone; what the others lie on is written.
      if (drape_file(name, hang) == name) continue;
      const int exit = write_one(simulate_drape(name, hang), (folder / (drape_file(name, hang) + ".glb")).string());
      if (exit != kDone) return exit;
    }
  }
  return kDone;
}

}  // namespace weftlight::commands
