// The Cloth menu: drape, light, picture quality and comparison.

#include "actions/action_parts.h"
#include "design/lights.h"
#include "drape/mesh.h"
#include "files/design_drape.h"

namespace weftlight::actions {

using base::fill, base::tr;
using design::Design, design::LightingPreset, design::is_environment, design::kLightingPresets, design::lit_by;
using drape::drape_names;
using session::Compare, session::DrapeStage, session::Settings, session::simulated_drape_edit;

namespace {

void add_simulated_drape(Actions& all, const ActiveDraft& draft, const ClothActions& cloth) {
  Action& own = add(all, "Cloth", "drape.own", tr("Simulate this fabric"), "", [&draft] {
    const bool on = !draft.document().now().scene.simulated_drape;
    draft.commit(simulated_drape_edit(on));
  });
  own.item.group = true;
  own.enabled = [&draft] { return files::can_drape(draft.document().now()); };
  own.checked = [&draft] { return draft.document().now().scene.simulated_drape; };
  Action& stop = add(all, "Cloth", "drape.stop", tr("Stop the simulation"), "", cloth.stop_drape);
  stop.enabled = [&cloth] { return cloth.drape().stage == DrapeStage::kSimulating; };
  Action& again = add(all, "Cloth", "drape.again", tr("Simulate again"), "", cloth.restart_drape);
  again.enabled = [&cloth] {
    const DrapeStage stage = cloth.drape().stage;
    return stage == DrapeStage::kStopped || stage == DrapeStage::kFailed;
  };
}

}  // namespace

void add_cloth_actions(Actions& all, const ActiveDraft& draft, const ClothActions& cloth, Settings& settings) {
  for (const std::string& name : drape_names()) {
    Action& a = add(all, "Cloth", ("drape." + name).c_str(),
                    fill(tr("Drape: {name}"), arg("name", tr(name.c_str()))).c_str(), "", [&draft, name] {
                      draft.commit({tr("Choose drape"), [name](Design d) {
                                      d.scene.mesh = name;
                                      return d;
                                    }});
                    });
    a.checked = [&draft, name] { return draft.document().now().scene.mesh == name; };
  }
  add_simulated_drape(all, draft, cloth);
  for (const LightingPreset& setup : kLightingPresets) {
    Action& a = add(all, "Cloth", (std::string("lights.") + setup.id).c_str(),
                    fill(tr("Light: {name}"), arg("name", tr(setup.label))).c_str(), "", [&draft, &setup] {
                      draft.commit({tr("Choose lights"), [&setup](Design d) {
                                      d.scene = lit_by(d.scene, setup);
                                      return d;
                                    }});
                    });
    a.item.group = &setup == &kLightingPresets.front();
    a.checked = [&draft, &setup] { return draft.document().now().scene.lights == setup.id; };
  }
  Action& picture =
      add(all, "Cloth", "environment", tr("Light: environment map\xE2\x80\xA6"), "", cloth.choose_environment);
  picture.checked = [&draft] { return is_environment(draft.document().now().scene.lights); };
  Action& flat = add(all, "Cloth", "flat", tr("Flat swatch"), "F", cloth.toggle_flat);
  flat.item.group = true;
  flat.checked = [&draft] { return draft.view().cloth.flat; };
  Action& grazing = add(all, "Cloth", "grazing", tr("Flat swatch in grazing light"), "Shift+F", [&draft, &cloth] {
    const bool on = draft.view().cloth.flat && draft.view().cloth.grazing;
    if (!draft.view().cloth.flat) cloth.toggle_flat();
    draft.view().cloth.grazing = !on;
  });
  grazing.checked = [&draft] { return draft.view().cloth.flat && draft.view().cloth.grazing; };
  Action& distance = add(all, "Cloth", "true_distance", tr("True distance"), "Shift+D", cloth.toggle_true_distance);
  distance.checked = [&draft] { return draft.view().cloth.flat && draft.view().cloth.true_distance; };
  add(all, "Cloth", "measure_screen", tr("Measure the screen with a card\xE2\x80\xA6"), "", cloth.measure_screen);
  Action& by_time = add(all, "Cloth", "by_time", tr("Limit time instead of error"), "",
                        [&settings] { settings.by_time = !settings.by_time; });
  by_time.checked = [&settings] { return settings.by_time; };
  Action& methods = add(all, "Cloth", "rungs", tr("Shading methods in false colours"), "F6",
                        [&settings] { settings.show_methods = !settings.show_methods; });
  methods.item.group = true;
  methods.checked = [&settings] { return settings.show_methods; };
  const auto comparison = [&all, &settings](const char* id, const char* label, const char* key, Compare to) {
    Action& a = add(all, "Cloth", id, label, key,
                    [&settings, to] { settings.compare = settings.compare == to ? Compare::kOff : to; });
    a.checked = [&settings, to] { return settings.compare == to; };
  };
  comparison("compare", tr("Compare with the ray-traced reference"), "F7", Compare::kSplit);
  comparison("difference", tr("Difference from the ray-traced reference"), "F8", Compare::kDifference);
}

}  // namespace weftlight::actions
