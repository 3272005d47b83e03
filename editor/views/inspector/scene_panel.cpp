#include "views/inspector/scene_panel.h"

#include <algorithm>

#include "draft/methods.h"
#include "drape/mesh.h"
#include "ui/widgets.h"

namespace weftlight::views {
namespace {

struct SceneSpec {
  SliderSpec slider;
  float Scene::*field;
};
const SceneSpec kLight[] = {
    {{"scene.light_azimuth", "Light from", -180, 180, "%.0f\xC2\xB0",
      "Azimuth of the light: 0 is in front, positive to the right. Or drag in the picture with the right button"},
     &Scene::light_azimuth},
    {{"scene.light_elevation", "Light height", 0, 90, "%.0f\xC2\xB0",
      "Elevation of the light: 0 grazes, 90 is straight above"},
     &Scene::light_elevation},
    {{"scene.light_strength", "Light", 0, 4, "%.2f", "Strength of the key light"}, &Scene::light_strength},
    {{"scene.sky_strength", "Sky", 0, 4, "%.2f", "Strength of the soft light from all around"}, &Scene::sky_strength},
};

template <class Apply>
Edit scene_edit(const char* label, Apply apply) {
  return {label, [apply](Design d) {
            apply(d);
            return d;
          }};
}

MaybeEdit draw_mesh(PanelContext& c) {
  row_label(c, "Drape", "What the cloth hangs on");
  ImGui::SetNextItemWidth(-FLT_MIN);
  MaybeEdit edit;
  if (begin_combo(c, "scene.mesh", c.design.scene.mesh.c_str())) {
    for (const std::string& name : drape_names()) {
      if (ImGui::Selectable(name.c_str(), name == c.design.scene.mesh))
        edit = scene_edit("Choose drape", [name](Design& d) { d.scene.mesh = name; });
      c.map.add_item("mesh:" + name);
    }
    end_combo();
  }
  return edit;
}

MaybeEdit draw_method(PanelContext& c) {
  row_label(c, "Method",
            "How the threads are shaded. Automatic takes the cheapest that is good enough at the distance");
  ImGui::SetNextItemWidth(-FLT_MIN);
  MaybeEdit edit;
  if (begin_combo(c, "look.method", method_facts(c.design.look.method).label)) {
    for (const MethodFacts& m : kMethods) {
      if (!m.drawn) continue;  // the reference is ray traced
      if (ImGui::Selectable(m.label, m.method == c.design.look.method))
        edit = scene_edit("Choose method", [&m](Design& d) { d.look.method = m.method; });
      c.map.add_item(std::string("method:") + m.label);
    }
    end_combo();
  }
  return edit;
}

}  // namespace

MaybeEdit draw_scene(PanelContext& c) {
  if (!section(c, "section.scene", "Cloth in the light")) return {};
  MaybeEdit edit = draw_mesh(c);
  if (MaybeEdit method = draw_method(c)) edit = std::move(method);
  float exposure = c.design.look.exposure_ev;
  constexpr SliderSpec kExposure{
      "look.exposure_ev", "Exposure", -3, 3, "%+.1f EV", "Brightness of the picture, in stops"};
  if (slider(c, kExposure, exposure))
    edit = scene_edit("Exposure", [exposure](Design& d) { d.look.exposure_ev = exposure; });
  Scene scene = c.design.scene;
  for (const SceneSpec& spec : kLight)
    if (slider(c, spec.slider, scene.*spec.field))
      edit = scene_edit(spec.slider.label, [scene](Design& d) { d.scene = scene; });
  return edit;
}

}  // namespace weftlight::views
