#include <cstdio>
#include <filesystem>

#include "base/files.h"
#include "commands/commands.h"
#include "drape/mesh.h"
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

/// NAME.glb and, where the drape lies on something, NAME_body.glb beside it.
int write_drape(const std::string& name, const std::filesystem::path& path) {
  if (const int exit = write_one(simulate_drape(name), path.string()); exit != kDone) return exit;
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
    if (extension == ".glb" || extension == ".gltf") return write_drape(options.name, options.out);
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
    const int exit = write_drape(name, std::filesystem::path(options.out) / (name + ".glb"));
    if (exit != kDone) return exit;
  }
  return kDone;
}

}  // namespace weftlight::commands
