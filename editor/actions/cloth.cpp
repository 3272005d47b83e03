// The Cloth menu: drape, light, picture quality and comparison.

#include "actions/action_parts.h"
#include "draft/lights.h"
#include "drape/mesh.h"
#include "files/design_drape.h"

namespace weftlight::actions {
namespace {

void add_simulated_drape(Actions& all) {
  Action& own = add(all, "Cloth", "drape.own", tr("Simulate this fabric"), "", [](ActionHost& e) {
    const bool on = !e.document().now().scene.simulated_drape;
    e.commit(simulated_drape_edit(on));
  });
  own.item.group = true;
  own.enabled = [](const ActionHost& e) { return files::can_drape(e.document().now()); };
  own.checked = [](const ActionHost& e) { return e.document().now().scene.simulated_drape; };
  Action& stop =
      add(all, "Cloth", "drape.stop", tr("Stop the simulation"), "", [](ActionHost& e) { e.stop_draping(); });
  stop.enabled = [](const ActionHost& e) { return e.drape_state().stage == DrapeStage::kFalling; };
  Action& again = add(all, "Cloth", "drape.again", tr("Simulate again"), "", [](ActionHost& e) { e.drape_again(); });
  again.enabled = [](const ActionHost& e) {
    const DrapeStage stage = e.drape_state().stage;
    return stage == DrapeStage::kStopped || stage == DrapeStage::kFailed;
  };
}

}  // namespace

void add_cloth_actions(Actions& all) {
  for (const std::string& name : drape_names()) {
    Action& a = add(all, "Cloth", ("drape." + name).c_str(), fill(tr("Drape: {name}"), arg("name", name)).c_str(), "",
                    [name](ActionHost& e) {
                      e.commit({tr("Choose drape"), [name](Design d) {
                                  d.scene.mesh = name;
                                  return d;
                                }});
                    });
    a.checked = [name](const ActionHost& e) { return e.document().now().scene.mesh == name; };
  }
  add_simulated_drape(all);
  for (const LightingPreset& setup : kLightingPresets) {
    Action& a = add(all, "Cloth", (std::string("lights.") + setup.id).c_str(),
                    fill(tr("Light: {name}"), arg("name", tr(setup.label))).c_str(), "", [&setup](ActionHost& e) {
                      e.commit({tr("Choose lights"), [&setup](Design d) {
                                  d.scene = lit_by(d.scene, setup);
                                  return d;
                                }});
                    });
    a.item.group = &setup == &kLightingPresets.front();
    a.checked = [&setup](const ActionHost& e) { return e.document().now().scene.lights == setup.id; };
  }
  Action& picture = add(all, "Cloth", "environment", tr("Light: environment picture\xE2\x80\xA6"), "",
                        [](ActionHost& e) { e.ask_environment(); });
  picture.checked = [](const ActionHost& e) { return is_environment(e.document().now().scene.lights); };
  Action& flat = add(all, "Cloth", "flat", tr("Flat swatch"), "F", [](ActionHost& e) { e.toggle_flat(); });
  flat.item.group = true;
  flat.checked = [](const ActionHost& e) { return e.view().cloth.flat; };
  Action& grazing = add(all, "Cloth", "grazing", tr("Flat swatch in grazing light"), "Shift+F", [](ActionHost& e) {
    const bool on = e.view().cloth.flat && e.view().cloth.grazing;
    if (!e.view().cloth.flat) e.toggle_flat();
    e.view().cloth.grazing = !on;
  });
  grazing.checked = [](const ActionHost& e) { return e.view().cloth.flat && e.view().cloth.grazing; };
  Action& by_time = add(all, "Cloth", "by_time", tr("Limit time instead of error"), "",
                        [](ActionHost& e) { e.settings().by_time = !e.settings().by_time; });
  by_time.checked = [](const ActionHost& e) { return e.settings().by_time; };
  Action& methods = add(all, "Cloth", "rungs", tr("Shading methods in false colours"), "F6",
                        [](ActionHost& e) { e.settings().show_methods = !e.settings().show_methods; });
  methods.item.group = true;
  methods.checked = [](const ActionHost& e) { return e.settings().show_methods; };
  const auto comparison = [&all](const char* id, const char* label, const char* key, Compare to) {
    Action& a = add(all, "Cloth", id, label, key,
                    [to](ActionHost& e) { e.settings().compare = e.settings().compare == to ? Compare::kOff : to; });
    a.checked = [to](const ActionHost& e) { return e.settings().compare == to; };
  };
  comparison("compare", tr("Compare with the ray-traced reference"), "F7", Compare::kSplit);
  comparison("difference", tr("Difference from the ray-traced reference"), "F8", Compare::kDifference);
}

}  // namespace weftlight::actions
