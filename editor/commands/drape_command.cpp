#include <cstdio>
#include <filesystem>

#include "base/files.h"
#include "commands/commands.h"
#include "drape/hang.h"
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

Hang hang_called(const std::string& name) {
  for (const Hang hang : kHangs)
    if (name == kHangNames[static_cast<size_t>(hang)]) return hang;
  return Hang::kMedium;
}

/// NAME.glb and, where the drape lies on something, NAME_body.glb beside it.
int write_drape(const std::string& name, Hang hang, const std::filesystem::path& path) {
  if (const int exit = write_one(simulate_drape(name, hang), path.string()); exit != kDone) return exit;
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

int refuse(const std::string& name) {
  std::fprintf(stderr, "weftlight: no drape is called '%s'; there are: all", name.c_str());
  for (const std::string& known : drape_names()) std::fprintf(stderr, ", %s", known.c_str());
  std::fprintf(stderr, "\n");
  return kUsage;
}

}  // namespace

int drape_command(const DrapeOptions& options) {
  if (options.name != "all") {
    if (!is_known(options.name)) return refuse(options.name);
    const std::string extension = std::filesystem::path(options.out).extension().string();
    if (extension == ".glb" || extension == ".gltf")
      return write_drape(options.name, hang_called(options.hang), options.out);
    std::fprintf(stderr, "weftlight: %s: a drape is written as .glb or .gltf\n", options.out.c_str());
    return kUsage;
  }
  std::error_code problem;
  std::filesystem::create_directories(options.out, problem);
  if (problem) {
    std::fprintf(stderr, "%s: the folder cannot be made: %s\n", options.out.c_str(), cause_of(problem.value()).c_str());
    return kNotWritten;
  }
  for (const std::string& name : drape_names()) {
    const std::filesystem::path folder(options.out);
    if (const int exit = write_drape(name, Hang::kMedium, folder / (name + ".glb")); exit != kDone) return exit;
    for (const Hang hang : {Hang::kLimp, Hang::kStiff}) {
      // The plane has one alone; what the others lie on is written.
      if (drape_file(name, hang) == name) continue;
      const int exit = write_one(simulate_drape(name, hang), (folder / (drape_file(name, hang) + ".glb")).string());
      if (exit != kDone) return exit;
    }
  }
  return kDone;
}

}  // namespace weftlight::commands
