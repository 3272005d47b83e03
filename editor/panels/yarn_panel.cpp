#include "panels/yarn_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "draft/yarn_presets.h"
#include "panels/icons.h"
#include "panels/lobes_plot.h"
#include "panels/paint.h"
#include "panels/widgets.h"

namespace weftlight::panels {
namespace {

constexpr float kStripHeight = 84;  // pixels at 96 dpi

struct FieldSpec {
  SliderSpec slider;
  float Yarn::*field;
};
struct LobeSpec {
  SliderSpec slider;
  float Lobes::*field;
};

// Ranges as in draft/yarn.h.
const FieldSpec kBody[] = {
    {{"yarn.diameter_mm", "Thickness", 0.05f, 5, "%.2f mm", "Diameter, where the draft itself gives none", true},
     &Yarn::diameter_mm},
    {{"yarn.turns_per_m", "Twist", 0, 2000, "%.0f /m", "Turns in a metre: how steep the fibres wind"},
     &Yarn::turns_per_m},
    {{"yarn.fibre_um", "Fibre bundles", 5, 500, "%.0f \xC2\xB5m",
      "Width of the bundles seen between the grooves of the twist", true},
     &Yarn::fibre_um},
    {{"yarn.groove_depth", "Grooves", 0, 1, "%.2f", "How dark the grooves between the fibres are"},
     &Yarn::groove_depth},
    {{"yarn.hairiness", "Hairiness", 0, 1, "%.2f", "Stray fibres: noise along the thread"}, &Yarn::hairiness},
    {{"yarn.flattening", "Roundness", 0.3f, 1, "%.2f", "Height over width of the thread in the cloth: 1 is round"},
     &Yarn::flattening},
};
const LobeSpec kLight[] = {
    {{"yarn.specular", "Shine", 0, 1, "%.2f", "Strength of the light mirrored along the fibres"}, &Lobes::specular},
    {{"yarn.along_width", "Spread along", 0.02f, 2, "%.2f", "RMS slope along the fibre: small is glossy, large is dull",
      true},
     &Lobes::along_width},
    {{"yarn.across_width", "Spread across", 0.02f, 2, "%.2f", "RMS slope across the fibre", true},
     &Lobes::across_width},
    {{"yarn.ior", "Refraction", 1, 3, "%.2f", "Index of refraction: cotton 1.53, silk 1.56, polyester 1.6"},
     &Lobes::ior},
    {{"yarn.body", "Body", 0, 1, "%.2f", "Light that entered the thread and leaves it in the thread's colour"},
     &Lobes::body},
    {{"yarn.fuzz", "Fuzz", 0, 1, "%.2f", "Fibres that stand off, seen at grazing angles and at the edge"},
     &Lobes::fuzz},
    {{"yarn.fuzz_width", "Fuzz spread", 0.05f, 1, "%.2f", "Roughness of the fuzz"}, &Lobes::fuzz_width},
    {{"yarn.transmission", "Translucence", 0, 1, "%.2f", "Share of the body's light that passes through from behind"},
     &Lobes::transmission},
};

MaybeEdit changed(int index, const Yarn& yarn, const std::string& what) {
  return Edit{std::string("Yarn: ").append(what), [=](Design d) { return with_yarn(std::move(d), index, yarn); }};
}

MaybeEdit add_yarn(PanelContext& c, const Yarn& yarn) {
  c.work.yarn = static_cast<int>(c.design.yarns.size());
  return Edit{"Add yarn", [yarn](Design d) { return with_new_yarn(std::move(d), yarn); }};
}

/// What the plus button offers.
MaybeEdit draw_ready_yarns(PanelContext& c) {
  if (!ImGui::BeginPopup("ready yarns")) return {};
  MaybeEdit edit;
  if (ImGui::MenuItem("Like this one")) edit = add_yarn(c, c.design.yarns[static_cast<size_t>(c.work.yarn)]);
  c.map.add_item("yarn.add:like");
  ImGui::Separator();
  for (const Yarn& yarn : yarn_presets()) {
    if (ImGui::MenuItem(yarn.name.c_str())) edit = add_yarn(c, yarn);
    c.map.add_item("yarn.add:" + yarn.name);
  }
  ImGui::EndPopup();
  return edit;
}

/// The list as a drop-down, with the name editable beside it, and a button for a new yarn.
MaybeEdit draw_choice(PanelContext& c) {
  const auto& yarns = c.design.yarns;
  const float add = ImGui::GetFrameHeight() + c.style.px(12);
  row_label(c, "Yarn in hand", "The yarn shown here, and painted on the bars when they paint yarns");
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - add);
  const auto title = [&](int i) {
    return std::to_string(i + 1).append("  ").append(yarns[static_cast<size_t>(i)].name);
  };
  if (begin_combo(c, "yarn.list", title(c.work.yarn).c_str())) {
    for (int i = 0; i < static_cast<int>(yarns.size()); ++i) {
      ImGui::PushID(i);
      if (ImGui::Selectable(title(i).c_str(), i == c.work.yarn)) c.work.yarn = i;
      ImGui::PopID();
      c.map.add_item("yarn:" + std::to_string(i + 1));
    }
    end_combo();
  }
  ImGui::SameLine();
  if (icon_button(c, "yarn.add", icon::kPlus, "+", "Add a yarn: one like this, or a ready one"))
    ImGui::OpenPopup("ready yarns");
  return draw_ready_yarns(c);
}

bool draw_name(PanelContext& c, Yarn& yarn) {
  row_label(c, "Name", "What the yarn is called");
  ImGui::SetNextItemWidth(-FLT_MIN);
  const bool typed = ImGui::InputText("##name", &yarn.name);
  c.map.add_item("yarn.name");
  return typed;
}

bool draw_twist(PanelContext& c, Yarn& yarn) {
  row_label(c, "Twist", "Z twist leans like the middle stroke of the letter Z, S twist like that of S");
  constexpr const char* kTwists[] = {"None", "S", "Z"};
  int twist = static_cast<int>(yarn.twist);
  if (!segmented(c, "yarn.twist", kTwists, twist)) return false;
  yarn.twist = static_cast<Twist>(twist);
  return true;
}

/// A thread of the yarn in the colour in hand.
void draw_strip(PanelContext& c, const Yarn& yarn, Rgb colour, YarnStrip& strip) {
  const float width = ImGui::GetContentRegionAvail().x, height = c.style.px(kStripHeight);
  ImGui::Image(strip.of(yarn, colour, c.work.lobe_light_deg, static_cast<int>(width), static_cast<int>(height)),
               {width, height});
  c.map.add_item("yarn.strip");
  tooltip(c, "A thread of this yarn in the colour in hand, under the light of the plot");
}

MaybeEdit draw_light(PanelContext& c, Yarn yarn, YarnStrip& strip) {
  if (!section(c, "section.lobes", "Light on the yarn")) return {};
  const auto& palette = c.design.draft.palette;
  const Rgb colour = palette[std::min(static_cast<size_t>(std::max(c.work.color, 0)), palette.size() - 1)];
  const ImVec2 pictures = ImGui::GetCursorPos();
  const float width = ImGui::GetContentRegionAvail().x;
  // Kept free: drawn last, so that they show what the sliders have just become.
  ImGui::Dummy({width, c.style.px(kStripHeight) + lobes_plot_height(c, width) + 2 * ImGui::GetStyle().ItemSpacing.y});
  MaybeEdit edit;
  for (const LobeSpec& spec : kLight)
    if (slider(c, spec.slider, yarn.lobes.*spec.field)) edit = changed(c.work.yarn, yarn, spec.slider.label);
  row_label(c, "Metallic", "Lurex and metal threads: the shine takes the thread's colour, and there is no body");
  if (ImGui::Checkbox("##metallic", &yarn.lobes.metallic)) edit = changed(c.work.yarn, yarn, "Metallic");
  c.map.add_item("yarn.metallic");
  const ImVec2 after = ImGui::GetCursorPos();
  ImGui::SetCursorPos(pictures);
  draw_strip(c, yarn, colour, strip);
  draw_lobes_plot(c, yarn.lobes, colour);
  ImGui::SetCursorPos(after);
  return edit;
}

}  // namespace

MaybeEdit draw_yarns(PanelContext& c, YarnStrip& strip) {
  c.work.yarn = std::clamp(c.work.yarn, 0, static_cast<int>(c.design.yarns.size()) - 1);
  Yarn yarn = c.design.yarns[static_cast<size_t>(c.work.yarn)];
  MaybeEdit edit;
  if (section(c, "section.yarns", "Yarns")) {
    edit = draw_choice(c);
    if (edit) return edit;
    if (draw_name(c, yarn)) edit = changed(c.work.yarn, yarn, "Name");
    if (draw_twist(c, yarn)) edit = changed(c.work.yarn, yarn, "Twist");
    for (const FieldSpec& spec : kBody)
      if (slider(c, spec.slider, yarn.*spec.field)) edit = changed(c.work.yarn, yarn, spec.slider.label);
  }
  if (MaybeEdit light = draw_light(c, yarn, strip)) edit = std::move(light);
  return edit;
}

}  // namespace weftlight::panels
