#include "views/inspector/scene_panel.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "draft/lights.h"
#include "draft/methods.h"
#include "drape/mesh.h"
#include "ui/widgets.h"
#include "views/inspector/drape_stiffness_rows.h"

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

ImU32 mixed(Rgb a, Rgb b, float t) {
  return to_u32({a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t});
}

/// A white ball in the set-up's light, before its background.
void draw_ball(const PanelContext& c, const LightingPreset& setup, ImVec2 a, ImVec2 b) {
  constexpr float kDegree = 3.14159265f / 180;
  constexpr int kRings = 10;
  ImDrawList* dl = ImGui::GetWindowDrawList();
  dl->AddRectFilled(a, b, to_u32(setup.background), c.style.px(4));
  const float r = 0.38f * (b.y - a.y), up = std::sin(setup.elevation * kDegree);
  const float side = std::sin(setup.azimuth * kDegree) * std::cos(setup.elevation * kDegree);
  const ImVec2 middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
  for (int k = 0; k <= kRings; ++k) {
    const float t = static_cast<float>(k) / kRings, inner = r * (1 - t), off = 0.8f * (r - inner);
    dl->AddCircleFilled({middle.x + side * off, middle.y - up * off}, inner, mixed(setup.shaded, setup.lit, t), 24);
  }
}

/// Rows of small pictures, their names below.
MaybeEdit draw_setups(PanelContext& c) {
  constexpr size_t kColumns = 3;
  const float gap = c.style.px(6), line = ImGui::GetTextLineHeight(), row_gap = c.style.px(12);
  const float width = (ImGui::GetContentRegionAvail().x - gap * (kColumns - 1)) / kColumns, height = c.style.px(44);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  MaybeEdit edit;
  ImDrawList* dl = ImGui::GetWindowDrawList();
  for (size_t i = 0; i < kLightSetups.size(); ++i) {
    const LightingPreset& setup = kLightSetups[i];
    const ImVec2 a{at.x + static_cast<float>(i % kColumns) * (width + gap),
                   at.y + static_cast<float>(i / kColumns) * (height + line + row_gap)},
        b{a.x + width, a.y + height};
    ImGui::SetCursorScreenPos(a);
    if (hit_area(setup.id, {width, height + line}))
      edit = scene_edit("Choose lights", [&setup](Design& d) { d.scene = lit_by(d.scene, setup); });
    c.map.add_item(std::string("lights:") + setup.id);
    tooltip(c, setup.tip);
    const bool chosen = c.design.scene.lights == setup.id, over = ImGui::IsItemHovered();
    draw_ball(c, setup, a, b);
    if (chosen || over)
      dl->AddRect({a.x + 1, a.y + 1}, {b.x - 1, b.y - 1}, chosen ? c.style.color.accent : c.style.color.line_strong,
                  c.style.px(4), 0, 2.0f);
    const float room = (width - ImGui::CalcTextSize(setup.label).x) / 2;
    dl->AddText({a.x + std::max(0.0f, room), b.y + c.style.px(2)}, chosen ? c.style.color.text : c.style.color.muted,
                setup.label);
  }
  constexpr size_t kRows = (kLightSetups.size() + kColumns - 1) / kColumns;
  ImGui::SetCursorScreenPos({at.x, at.y + static_cast<float>(kRows) * (height + line + row_gap)});
  return edit;
}

/// Light from a picture: its name, and whether it shows.
MaybeEdit draw_picture(PanelContext& c) {
  const bool pictured = is_environment(c.design.scene.lights);
  const size_t slash = c.design.scene.lights.find_last_of('/');
  const std::string name = pictured ? c.design.scene.lights.substr(slash + 1) : "From a picture\xE2\x80\xA6";
  row_label(c, "Around", "Light from all around the cloth, from an .hdr or an .exr that is twice as wide as high");
  if (text_button(c, "scene.environment", fitted(name, ImGui::GetContentRegionAvail().x * 0.8f).c_str(),
                  "Choose the picture"))
    c.wanted.add_action("environment");
  if (!pictured) return {};
  row_label(c, "Behind the cloth", "What is behind the cloth in the picture");
  constexpr const char* kBehind[] = {"Backdrop", "Picture"};
  int shown = c.design.scene.surroundings ? 1 : 0;
  if (!segmented(c, "scene.surroundings", kBehind, shown)) return {};
  return scene_edit("Show what is around", [shown](Design& d) { d.scene.surroundings = shown == 1; });
}

MaybeEdit draw_exposure(PanelContext& c) {
  MaybeEdit edit;
  float exposure = c.design.look.exposure_ev;
  constexpr SliderSpec kExposure{
      "look.exposure_ev", "Exposure", -3, 3, "%+.1f EV", "Brightness of the picture, in stops"};
  if (slider(c, kExposure, exposure))
    edit = scene_edit("Exposure", [exposure](Design& d) { d.look.exposure_ev = exposure; });
  row_label(c, "Exposed",
            "By the cloth: the less it reflects, the more it is lifted, white ones the least, beside the stops");
  constexpr const char* kBy[] = {"By the cloth", "As it is"};
  int by = c.design.look.automatic_exposure ? 0 : 1;
  if (segmented(c, "look.automatic_exposure", kBy, by))
    edit = scene_edit("Exposure", [by](Design& d) { d.look.automatic_exposure = by == 0; });
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
  if (MaybeEdit own = draw_drape_stiffness(c)) edit = std::move(own);
  if (MaybeEdit lights = draw_setups(c)) edit = std::move(lights);
  if (MaybeEdit picture = draw_picture(c)) edit = std::move(picture);
  if (MaybeEdit method = draw_method(c)) edit = std::move(method);
  if (MaybeEdit exposure = draw_exposure(c)) edit = std::move(exposure);
  Scene scene = c.design.scene;
  for (const SceneSpec& spec : kLight)
    if (!(is_environment(scene.lights) && spec.field == &Scene::light_elevation) &&
        slider(c, spec.slider, scene.*spec.field))
      edit = scene_edit(spec.slider.label, [scene](Design& d) { d.scene = scene; });
  return edit;
}

}  // namespace weftlight::views
