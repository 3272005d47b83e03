// Texture sets for engines and renderers.

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>

#include "base/version.h"
#include "files/design_drape.h"
#include "python/bindings.h"
#include "python/long_call.h"
#include "texture_set/targets.h"
#include "texture_set/texture_set.h"

namespace weftlight::python {

using base::TaskProgress;
using design::Design;
using drape::Mesh;
using files::MipFormat;
using texture_set::Alpha, texture_set::ExportTarget, texture_set::TextureSetOptions, texture_set::alpha_named,
    texture_set::file_name_of, texture_set::kTargets, texture_set::target_named, texture_set::write_texture_set;

namespace {

namespace fs = std::filesystem;

const ExportTarget& target_of(const std::string& id) {
  if (const ExportTarget* target = target_named(id)) return *target;
  std::string ids;
  for (const ExportTarget* target : kTargets) ids.append(ids.empty() ? "" : ", ").append(target->id);
  bad_value(fmt::format("no target is called '{}'; the targets are {}", id, ids));
}

std::optional<MipFormat> mip_format_of(const std::optional<std::string>& mips) {
  if (!mips) return std::nullopt;
  if (const auto format = files::mip_format_named(*mips)) return format;
  bad_value(fmt::format("'{}' is not one of 'dds', 'ktx2', 'dds-bc', 'ktx2-bc'", *mips));
}

Alpha alpha_of(const std::string& name) {
  if (const auto alpha = alpha_named(name)) return *alpha;
  bad_value(fmt::format("'{}' is not one of 'auto', 'opaque', 'mask', 'hashed', 'blend'", name));
}

void check_size(int size) {
  if (size < 16 || size > 8192 || (size & (size - 1)) != 0) bad_value("size is a power of two of 16 to 8192");
}

/// The chosen mesh, in its version for this fabric.
Mesh mesh_for(const ExportTarget& target, Design design, const std::string& mesh) {
  if (!target.wears_mesh) return {};
  design.scene.mesh = mesh;
  return value_of(files::load_worn_drape(design));
}

std::vector<std::string> export_set(const Design& design, const fs::path& folder, const std::string& target, int size,
                                    const std::string& name, const std::string& mesh, const std::string& alpha,
                                    double distance_m, const std::optional<double>& tile_mm,
                                    const std::optional<std::string>& mips, int lod, bool force,
                                    const py::object& progress) {
  check_size(size);
  if (lod < 0 || lod >= texture_set::kLods) bad_value("lod is 0 to 2");
  if (!(tile_mm.value_or(0) >= 0 && distance_m >= 0)) bad_value("tile_mm and distance_m are 0 or more");
  TextureSetOptions options;
  options.target = &target_of(target);
  options.name = file_name_of(!name.empty() ? name : !design.title.empty() ? design.title : folder.filename().string());
  options.program_version = base::version();
  options.size = size, options.force = force;
  options.alpha = alpha_of(alpha);
  options.mips = mip_format_of(mips);
  options.distance_m = static_cast<float>(distance_m);
  options.tile_mm = tile_mm ? static_cast<float>(*tile_mm) : texture_set::kTileOfYarns;
  options = texture_set::at_lod(options, lod);
  return long_call(progress, [&](const TaskProgress& task) {
    const Mesh worn = mesh_for(*options.target, design, mesh);
    value_of(write_texture_set(folder.string(), design, worn, options,
                               {[&task](float share) { task.report(share, "writing the textures"); }, task.stop()}));
    return texture_set::warnings_of(design, options);
  });
}

}  // namespace

void bind_export(py::module_& module) {
  std::vector<std::string> ids;
  for (const ExportTarget* target : kTargets) ids.emplace_back(target->id);
  module.attr("TARGETS") = py::tuple(py::cast(ids));
  module.def("export", &export_set, py::arg("design"), py::arg("folder"), py::arg("target") = "gltf", py::kw_only(),
             py::arg("size") = 1024, py::arg("name") = "", py::arg("mesh") = "plane", py::arg("alpha") = "auto",
             py::arg("distance_m") = 1.0, py::arg("tile_mm") = py::none(), py::arg("mips") = py::none(),
             py::arg("lod") = 0, py::arg("force") = false, py::arg("progress") = py::none(),
             "A texture set of the design into a folder; returns remarks.");
}

}  // namespace weftlight::python
