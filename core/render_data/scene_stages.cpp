#include "render_data/scene_stages.h"

#include <algorithm>

#include "files/design_drape.h"

namespace weftlight::render_data {

using design::Design;
using drape::Mesh, drape::drape_names, drape::simulate_drape;
using files::load_design_drape;
using scene::LightRig, scene::load_light_rig;

namespace {

base::Result<Mesh> find_mesh(const Design& design) {
  const std::string& name = design.scene.mesh;
  base::Result<Mesh> read = load_design_drape(design);
  const std::vector<std::string>& shipped = drape_names();
  const bool is_shipped = std::find(shipped.begin(), shipped.end(), name) != shipped.end();
  if (!read && is_shipped) read = simulate_drape(name);
  if (read && is_shipped) read->name = name;
  return read;
}

}  // namespace

base::Result<Outcome> update_mesh(StageWork& work, Change) {
  if (work.input.drape.empty()) return Outcome{Change::kNone};  // the caller has a mesh of its own
  const base::Result<Mesh> read = find_mesh(work.design());
  if (!read) return failed(read);
  work.result.mesh = prepare_mesh(*read, work.quick() ? SkyRays::kFew : SkyRays::kAll);
  return Outcome{Change::kAll, work.quick()};
}

base::Result<Outcome> update_lights(StageWork& work, Change) {
  base::Result<LightRig> rig = load_light_rig(work.design().scene.lights);
  if (!rig) return failed(rig);
  work.result.lights = std::move(*rig);
  return {};
}

}  // namespace weftlight::render_data
