#include <cstdlib>
#include <filesystem>

#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif

#include "files/files.h"

namespace weftlight::files {
namespace fs = std::filesystem;

namespace {

fs::path program_path() {
  std::error_code ec;
#ifdef __APPLE__
  char buffer[4096];
  uint32_t size = sizeof buffer;
  return _NSGetExecutablePath(buffer, &size) == 0 ? fs::canonical(buffer, ec) : fs::path();
#else
  return fs::read_symlink("/proc/self/exe", ec);
#endif
}

/// A presets folder is known by its meshes or drafts, so that another program's folder is not taken.
bool is_presets(const fs::path& folder) {
  std::error_code ec;
  return fs::is_directory(folder / "drafts", ec) || fs::is_directory(folder / "meshes", ec);
}

std::string names_of_drapes() {
  std::string names;
  for (const std::string& name : drape_names()) names += (names.empty() ? "" : ", ") + name;
  return names;
}

}  // namespace

std::string presets_dir() {
  if (const char* set = std::getenv("WEFTLIGHT_PRESETS"); set && *set) return set;
  const fs::path program = program_path();
  if (const fs::path share = program.parent_path() / "../share/weftlight/presets"; is_presets(share)) {
    return share.lexically_normal().string();
  }
  // From build/release, and from a copy of the program put beside its presets.
  fs::path folder = program.parent_path();
  for (int up = 0; up < 4 && folder.has_relative_path(); ++up, folder = folder.parent_path()) {
    if (is_presets(folder / "presets")) return (folder / "presets").string();
  }
  return WEFTLIGHT_SOURCE_DIR "/presets";
}

ReadMesh load_drape(const std::string& name_or_path) {
  std::error_code ec;
  for (const std::string& name : drape_names()) {
    if (name != name_or_path) continue;
    const fs::path shipped = fs::path(presets_dir()) / "meshes" / (name + ".glb");
    if (!fs::exists(shipped, ec)) return {simulate_drape(name), {}};
    ReadMesh read = read_mesh(shipped.string());
    if (read.mesh) read.mesh->name = name;
    return read;
  }
  const std::string extension = fs::path(name_or_path).extension().string();
  if (extension == ".glb" || extension == ".gltf" || fs::exists(name_or_path, ec)) return read_mesh(name_or_path);
  return {{},
          "no mesh is called '" + name_or_path + "'; give one of " + names_of_drapes() + ", or a .glb or .gltf file"};
}

}  // namespace weftlight::files
