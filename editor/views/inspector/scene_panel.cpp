#include "views/inspector/scene_panel.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/text.h"
#include "design/lights.h"
#include "design/methods.h"
#include "drape/mesh.h"
#include "ui/widgets.h"
#include "views/inspector/drape_stiffness_rows.h"

namespace weftlight::views {

using base::mark, base::tr;
using design::Design, design::LightingPreset, design::MethodFacts, design::Scene, design::is_environment,
    design::kLightingPresets, design::kMethods, design::lit_by, design::method_facts;
using draft::Rgb;
using drape::drape_names;
using session::Edit;
using ui::SliderSpec, ui::begin_combo, ui::end_combo, ui::fitted, ui::hit_area, ui::row_label, ui::section,
    ui::segmented, ui::slider, ui::text_button, ui::tooltip, ui::translated;

namespace {

struct SceneSpec {
  SliderSpec slider;
  float Scene::*field;
};
const SceneSpec kLight[] = {
    {{"scene.light_azimuth", mark("Light azimuth"), -180, 180, "%.0f\xC2\xB0",
      mark("Direction of the key light: 0 is in front, positive to the right. Or drag in the picture with the right "
           "button")},
     &Scene::light_azimuth},
    {{"scene.light_elevation", mark("Light elevation"), 0, 90, "%.0f\xC2\xB0",
      mark("Elevation of the key light: 0 is grazing, 90 is straight above")},
     &Scene::light_elevation},
    {{"scene.light_strength", mark("Key light"), 0, 4, "%.2f", mark("Strength of the key light")},
     &Scene::light_strength},
    {{"scene.sky_strength", mark("Environment"), 0, 4, "%.2f", mark("Strength of the soft light from all around")},
     &Scene::sky_strength},
};

template <class Apply>
Edit scene_edit(std::string label, Apply apply) {
  return {std::move(label), [apply](Design d) {
            apply(d);
            return d;
          }};
}

MaybeEdit draw_mesh(PanelContext& c) {
  row_label(c, tr("Shape"), tr("What the cloth is draped over"));
  ImGui::SetNextItemWidth(-FLT_MIN);
  MaybeEdit edit;
  if (begin_combo(c, "scene.mesh", tr(c.design.scene.mesh.c_str()))) {
    for (const std::string& name : drape_names()) {
      if (ImGui::Selectable(tr(name.c_str()), name == c.design.scene.mesh))
        edit = scene_edit(tr("Choose shape"), [name](Design& d) { d.scene.mesh = name; });
      c.map.add_item("mesh:" + name);
    }
    end_combo();
  }
  return edit;
}

ImU32 mixed(Rgb a, Rgb b, float t) {
  return to_u32({a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t});
}

/// A white ball in the light of the preset, in front of its background.
void draw_ball(const PanelContext& c, const LightingPreset& preset, ImVec2 a, ImVec2 b) {
  constexpr float kDegree = 3.14159265f / 180;
  constexpr int kRings = 10;
  ImDrawList* dl = ImGui::GetWindowDrawList();
  dl->AddRectFilled(a, b, to_u32(preset.background), c.style.px(4));
  const float r = 0.38f * (b.y - a.y), up = std::sin(preset.elevation * kDegree);
  const float side = std::sin(preset.azimuth * kDegree) * std::cos(preset.elevation * kDegree);
  const ImVec2 middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
  for (int k = 0; k <= kRings; ++k) {
    const float t = static_cast<float>(k) / kRings, inner = r * (1 - t), off = 0.8f * (r - inner);
    dl->AddCircleFilled({middle.x + side * off, middle.y - up * off}, inner, mixed(preset.shaded, preset.lit, t), 24);
  }
}

/// Rows of thumbnails with names below.
MaybeEdit draw_light_presets(PanelContext& c) {
  constexpr size_t kColumns = 3;
  const float gap = c.style.px(6), line = ImGui::GetTextLineHeight(), row_gap = c.style.px(12);
  const float width = (ImGui::GetContentRegionAvail().x - gap * (kColumns - 1)) / kColumns, height = c.style.px(44);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  MaybeEdit edit;
  ImDrawList* dl = ImGui::GetWindowDrawList();
  for (size_t i = 0; i < kLightingPresets.size(); ++i) {
    const LightingPreset& preset = kLightingPresets[i];
    const ImVec2 a{at.x + static_cast<float>(i % kColumns) * (width + gap),
                   at.y + static_cast<float>(i / kColumns) * (height + line + row_gap)},
        b{a.x + width, a.y + height};
    ImGui::SetCursorScreenPos(a);
    if (hit_area(preset.id, {width, height + line}))
      edit = scene_edit(tr("Choose lighting"), [&preset](Design& d) { d.scene = lit_by(d.scene, preset); });
    c.map.add_item(std::string("lights:") + preset.id);
    tooltip(c, tr(preset.tip));
    const bool chosen = c.design.scene.lights == preset.id, over = ImGui::IsItemHovered();
    draw_ball(c, preset, a, b);
    if (chosen || over)
      dl->AddRect({a.x + 1, a.y + 1}, {b.x - 1, b.y - 1}, chosen ? c.style.color.accent : c.style.color.line_strong,
                  c.style.px(4), 0, 2.0f);
    const char* label = tr(preset.label);
    const float room = (width - ImGui::CalcTextSize(label).x) / 2;
    dl->AddText({a.x + std::max(0.0f, room), b.y + c.style.px(2)}, chosen ? c.style.color.text : c.style.color.muted,
                label);
  }
  constexpr size_t kRows = (kLightingPresets.size() + kColumns - 1) / kColumns;
  ImGui::SetCursorScreenPos({at.x, at.y + static_cast<float>(kRows) * (height + line + row_gap)});
  return edit;
}

/// Light from an environment image: its name, and whether it is visible.
MaybeEdit draw_environment(PanelContext& c) {
  const bool has_image = is_environment(c.design.scene.lights);
  const size_t slash = c.design.scene.lights.find_last_of('/');
  const std::string name = has_image ? c.design.scene.lights.substr(slash + 1) : tr("Load image\xE2\x80\xA6");
  row_label(c, tr("Environment"), tr("Light from an environment map: an .hdr or .exr file, twice as wide as high"));
  if (text_button(c, "scene.environment", fitted(name, ImGui::GetContentRegionAvail().x * 0.8f).c_str(),
                  tr("Choose the image")))
    c.wanted.add_action("environment");
  if (!has_image) return {};
  row_label(c, tr("Background"), tr("What is behind the cloth in the picture"));
  constexpr const char* kBackgrounds[] = {mark("Backdrop"), mark("Image")};
  int shown = c.design.scene.surroundings ? 1 : 0;
  if (!segmented(c, "scene.surroundings", kBackgrounds, shown)) return {};
  return scene_edit(tr("Change background"), [shown](Design& d) { d.scene.surroundings = shown == 1; });
}

MaybeEdit draw_exposure(PanelContext& c) {
  MaybeEdit edit;
  float exposure = c.design.look.exposure_ev;
  const SliderSpec spec{
      "look.exposure_ev", tr("Exposure"), -3, 3, "%+.1f EV", tr("Brightness of the picture, in stops")};
  if (slider(c, spec, exposure))
    edit = scene_edit(tr("Change exposure"), [exposure](Design& d) { d.look.exposure_ev = exposure; });
  row_label(c, tr("Auto exposure"),
            tr("On: the less light a cloth reflects, the more it is brightened. No cloth is darkened"));
  constexpr const char* kBy[] = {mark("On"), mark("Off")};
  int by = c.design.look.automatic_exposure ? 0 : 1;
  if (segmented(c, "look.automatic_exposure", kBy, by))
    edit = scene_edit(tr("Change exposure"), [by](Design& d) { d.look.automatic_exposure = by == 0; });
  return edit;
}

MaybeEdit draw_method(PanelContext& c) {
  row_label(
      c, tr("Method"),
      tr("How the threads are shaded. Automatic takes the cheapest method that is accurate enough at the distance"));
  ImGui::SetNextItemWidth(-FLT_MIN);
  MaybeEdit edit;
  if (begin_combo(c, "look.method", tr(method_facts(c.design.look.method).label))) {
    for (const MethodFacts& m : kMethods) {
      if (!m.drawn) continue;  // the reference is ray traced
      if (ImGui::Selectable(tr(m.label), m.method == c.design.look.method))
        edit = scene_edit(tr("Choose method"), [&m](Design& d) { d.look.method = m.method; });
      c.map.add_item(std::string("method:") + m.label);
    }
    end_combo();
  }
  return edit;
}

}  // namespace

MaybeEdit draw_scene(PanelContext& c, const DrapeState& drape) {
  if (!section(c, "section.scene", tr("Cloth and light"))) return {};
  MaybeEdit edit = draw_mesh(c);
  if (MaybeEdit stiffness = draw_drape_stiffness(c, drape)) edit = std::move(stiffness);
  if (MaybeEdit lights = draw_light_presets(c)) edit = std::move(lights);
  if (MaybeEdit environment = draw_environment(c)) edit = std::move(environment);
  if (MaybeEdit method = draw_method(c)) edit = std::move(method);
  if (MaybeEdit exposure = draw_exposure(c)) edit = std::move(exposure);
  Scene scene = c.design.scene;
  for (const SceneSpec& spec : kLight)
    if (!(is_environment(scene.lights) && spec.field == &Scene::light_elevation) &&
        slider(c, translated(spec.slider), scene.*spec.field))
      edit = scene_edit(tr(spec.slider.label), [scene](Design& d) { d.scene = scene; });
  return edit;
}

}  // namespace weftlight::views
