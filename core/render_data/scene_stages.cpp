#include "render_data/scene_stages.h"

#include <algorithm>

#include "files/design_drape.h"

namespace weftlight::render_data {
namespace {

ReadMesh find_mesh(const Design& design) {
  const std::string& name = design.scene.mesh;
  ReadMesh read = load_design_drape(design);
  const std::vector<std::string>& shipped = drape_names();
  const bool is_shipped = std::find(shipped.begin(), shipped.end(), name) != shipped.end();
  if (!read.mesh && is_shipped) read = {simulate_drape(name), {}};
  if (read.mesh && is_shipped) read.mesh->name = name;
  return read;
}

}  // namespace

Outcome update_mesh(StageWork& work, Change) {
  if (work.input.drape.empty()) return {Change::kNone, false, {}};  // the caller has a mesh of its own
  const ReadMesh read = find_mesh(work.design());
  if (!read.mesh) return {Change::kNone, work.quick(), read.error};
  work.result.mesh = prepare_mesh(*read.mesh, work.quick() ? SkyRays::kFew : SkyRays::kAll);
  return {Change::kAll, work.quick(), {}};
}

Outcome update_lights(StageWork& work, Change) {
  std::string problem;
  LightRig rig = load_light_rig(work.design().scene.lights, problem);
  if (!problem.empty()) return {Change::kNone, false, std::move(problem)};
  work.result.lights = std::move(rig);
  return {};
}

}  // namespace weftlight::render_data
