// The cloth: what it hangs over, and what is laid beside its picture.

#include "actions/action_parts.h"
#include "draft/lights.h"
#include "drape/mesh.h"
#include "files/design_drape.h"

namespace weftlight::actions {
namespace {

void add_simulated_drape(Actions& all) {
  Action& own = add(all, "Cloth", "drape.own", "Drape this cloth", "", [](ActionHost& e) {
    const bool on = !e.document().now().scene.simulated_drape;
    e.commit(simulated_drape_edit(on));
  });
  own.item.group = true;
  own.enabled = [](const ActionHost& e) { return files::can_drape(e.document().now()); };
  own.checked = [](const ActionHost& e) { return e.document().now().scene.simulated_drape; };
  Action& stop = add(all, "Cloth", "drape.stop", "Stop draping", "", [](ActionHost& e) { e.stop_draping(); });
  stop.enabled = [](const ActionHost& e) { return e.drape_state().stage == DrapeStage::kFalling; };
  Action& again = add(all, "Cloth", "drape.again", "Drape it again", "", [](ActionHost& e) { e.drape_again(); });
  again.enabled = [](const ActionHost& e) {
    const DrapeStage stage = e.drape_state().stage;
    return stage == DrapeStage::kStopped || stage == DrapeStage::kFailed;
  };
}

}  // namespace

void add_cloth_actions(Actions& all) {
  for (const std::string& name : drape_names()) {
    Action& a = add(all, "Cloth", ("drape." + name).c_str(), ("Drape: " + name).c_str(), "", [name](ActionHost& e) {
      e.commit({"Choose drape", [name](Design d) {
                  d.scene.mesh = name;
                  return d;
                }});
    });
    a.checked = [name](const ActionHost& e) { return e.document().now().scene.mesh == name; };
  }
  add_simulated_drape(all);
  for (const LightingPreset& setup : kLightSetups) {
    Action& a = add(all, "Cloth", (std::string("lights.") + setup.id).c_str(),
                    (std::string("Light: ") + setup.label).c_str(), "", [&setup](ActionHost& e) {
                      e.commit({"Choose lights", [&setup](Design d) {
                                  d.scene = lit_by(d.scene, setup);
                                  return d;
                                }});
                    });
    a.item.group = &setup == &kLightSetups.front();
    a.checked = [&setup](const ActionHost& e) { return e.document().now().scene.lights == setup.id; };
  }
  Action& picture = add(all, "Cloth", "environment", "Light: a picture from all around\xE2\x80\xA6", "",
                        [](ActionHost& e) { e.ask_environment(); });
  picture.checked = [](const ActionHost& e) { return is_environment(e.document().now().scene.lights); };
  Action& flat = add(all, "Cloth", "flat", "Flat swatch, straight on", "F", [](ActionHost& e) { e.toggle_flat(); });
  flat.item.group = true;
  flat.checked = [](const ActionHost& e) { return e.view().flat; };
  Action& grazing = add(all, "Cloth", "grazing", "Flat swatch in grazing light", "Shift+F", [](ActionHost& e) {
    const bool on = e.view().flat && e.view().grazing;
    if (!e.view().flat) e.toggle_flat();
    e.view().grazing = !on;
  });
  grazing.checked = [](const ActionHost& e) { return e.view().flat && e.view().grazing; };
  Action& by_time = add(all, "Cloth", "by_time", "Picture by time, not by error", "",
                        [](ActionHost& e) { e.settings().by_time = !e.settings().by_time; });
  by_time.checked = [](const ActionHost& e) { return e.settings().by_time; };
  Action& methods = add(all, "Cloth", "rungs", "Methods in false colours", "F6",
                        [](ActionHost& e) { e.settings().show_methods = !e.settings().show_methods; });
  methods.item.group = true;
  methods.checked = [](const ActionHost& e) { return e.settings().show_methods; };
  const auto comparison = [&all](const char* id, const char* label, const char* key, Compare to) {
    Action& a = add(all, "Cloth", id, label, key,
                    [to](ActionHost& e) { e.settings().compare = e.settings().compare == to ? Compare::kOff : to; });
    a.checked = [to](const ActionHost& e) { return e.settings().compare == to; };
  };
  comparison("compare", "Compare with the ray-traced threads", "F7", Compare::kSplit);
  comparison("difference", "Difference from the ray-traced threads", "F8", Compare::kDifference);
}

}  // namespace weftlight::actions
