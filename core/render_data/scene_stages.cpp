#include "render_data/scene_stages.h"

#include "files/design_drape.h"

namespace weftlight::render_data {

using drape::Mesh;
using files::load_design_drape;
using scene::LightRig, scene::load_light_rig;

base::Result<Outcome> update_mesh(StageWork& work, Change) {
  if (work.input.drape.empty()) return Outcome{Change::kNone};  // the caller has a mesh of its own
  const base::Result<Mesh> read = load_design_drape(work.design());
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
