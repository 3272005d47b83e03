#include <algorithm>
#include <filesystem>

#include "base/file_names.h"
#include "base/resources.h"
#include "base/text.h"
#include "files/files.h"
#include "platform/shipped_file.h"

namespace weftlight::files {

using base::Result, base::fill, base::presets_dir, base::tr;
using drape::Mesh, drape::drape_names, drape::simulate_drape;

namespace fs = std::filesystem;
using base::arg;
using base::fill;
using base::Result;
using base::tr;

namespace {

std::string names_of_drapes() {
  std::string names;
  for (const std::string& name : drape_names()) names += (names.empty() ? "" : ", ") + name;
  return names;
}

}  // namespace

Result<void> check_drape(const std::string& name_or_path) {
  std::error_code ec;
  const std::string extension = base::extension_of(name_or_path);
  if (extension == ".glb" || extension == ".gltf" || fs::exists(name_or_path, ec)) return {};
  if (std::ranges::count(drape_names(), name_or_path) > 0) return {};
  return base::failure(base::ErrorKind::kInput,
                       fill(tr("no drape is called '{name}'; give one of {names}, or the path of a .glb or .gltf file"),
                            arg("name", name_or_path), arg("names", names_of_drapes())));
}

Result<Mesh> load_drape(const std::string& name_or_path) {
  for (const std::string& name : drape_names()) {
    if (name != name_or_path) continue;
    const fs::path shipped = fs::path(presets_dir()) / "meshes" / (name + ".glb");
    if (!platform::is_shipped(shipped.string())) return simulate_drape(name);
    Result<Mesh> read = read_mesh(shipped.string());
    if (read) read->name = name;
    return read;
  }
  return check_drape(name_or_path).and_then([&] { return read_mesh(name_or_path); });
}

}  // namespace weftlight::files
