#include "views/inspector/yarn_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "draft/yarn_fields.h"
#include "draft/yarn_presets.h"
#include "session/paint.h"
#include "ui/icons.h"
#include "ui/widgets.h"
#include "views/inspector/lobes_plot.h"

namespace weftlight::views {
namespace {

constexpr float kStripHeight = 84;  // pixels at 96 dpi

/// A field's slider. True while it changes `value`.
bool field_slider(const PanelContext& c, const FieldFacts& f, float& value) {
  const std::string id = std::string("yarn.").append(f.id);
  const std::string unit = *f.unit ? std::string(" ").append(f.unit) : std::string();
  const std::string format = "%." + std::to_string(f.decimals) + "f" + unit;
  return slider(c, {id.c_str(), f.label, f.from, f.to, format.c_str(), f.tip, f.logarithmic, f.low, f.high}, value);
}

/// The label of the field that was changed, or null.
template <class T, size_t N>
const char* field_sliders(const PanelContext& c, const std::array<YarnField<T>, N>& fields, T& value) {
  const char* label = nullptr;
  for (const YarnField<T>& field : fields)
    if (field_slider(c, field.facts, value.*field.member)) label = field.facts.label;
  return label;
}

MaybeEdit changed(int index, const Yarn& yarn, const std::string& what) {
  return Edit{std::string("Yarn: ").append(what), [=](Design d) { return with_yarn(std::move(d), index, yarn); }};
}

void take_in_hand(PanelContext& c, int yarn) {
  c.wanted.change_view([yarn](DocumentView& v) { v.yarn = yarn; });
}

MaybeEdit add_yarn(PanelContext& c, const Yarn& yarn) {
  take_in_hand(c, static_cast<int>(c.design.yarns.size()));
  return Edit{"Add yarn", [yarn](Design d) { return with_new_yarn(std::move(d), yarn); }};
}

/// What the plus button offers.
MaybeEdit draw_ready_yarns(PanelContext& c) {
  if (!ImGui::BeginPopup("ready yarns")) return {};
  MaybeEdit edit;
  if (ImGui::MenuItem("Like this one")) edit = add_yarn(c, c.design.yarns[static_cast<size_t>(c.view.yarn)]);
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
  if (begin_combo(c, "yarn.list", title(c.view.yarn).c_str())) {
    for (int i = 0; i < static_cast<int>(yarns.size()); ++i) {
      ImGui::PushID(i);
      if (ImGui::Selectable(title(i).c_str(), i == c.view.yarn)) take_in_hand(c, i);
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

bool draw_plies(PanelContext& c, Yarn& yarn) {
  float plies = static_cast<float>(yarn.plies);
  if (!field_slider(c, kPliesFacts, plies) || std::lround(plies) == yarn.plies) return false;
  yarn.plies = static_cast<int>(std::lround(plies));
  return true;
}

/// A thread of the yarn in the colour in hand.
void draw_strip(PanelContext& c, const Yarn& yarn, Rgb colour, YarnStrip& strip) {
  const float width = ImGui::GetContentRegionAvail().x, height = c.style.px(kStripHeight);
  ImGui::Image(strip.of(yarn, colour, c.settings.lobe_light_deg, static_cast<int>(width), static_cast<int>(height)),
               {width, height});
  c.map.add_item("yarn.strip");
  tooltip(c, "A thread of this yarn in the colour in hand, under the light of the plot");
}

MaybeEdit draw_light(PanelContext& c, Yarn yarn, YarnStrip& strip) {
  if (!section(c, "section.lobes", "Light on the yarn")) return {};
  const auto& palette = c.design.draft.palette;
  const Rgb colour = palette[std::min(static_cast<size_t>(std::max(c.view.color, 0)), palette.size() - 1)];
  const ImVec2 pictures = ImGui::GetCursorPos();
  const float width = ImGui::GetContentRegionAvail().x;
  // Kept free: drawn last, so that they show what the sliders have just become.
  ImGui::Dummy({width, c.style.px(kStripHeight) + lobes_plot_height(c, width) + 2 * ImGui::GetStyle().ItemSpacing.y});
  MaybeEdit edit;
  if (const char* what = field_sliders(c, kLobeFields, yarn.lobes)) edit = changed(c.view.yarn, yarn, what);
  row_label(c, "Metallic", "Lurex and metal threads: the shine takes the thread's colour, and there is no body");
  if (ImGui::Checkbox("##metallic", &yarn.lobes.metallic)) edit = changed(c.view.yarn, yarn, "Metallic");
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
  Yarn yarn = c.design.yarns[static_cast<size_t>(c.view.yarn)];
  MaybeEdit edit;
  if (section(c, "section.yarns", "Yarns")) {
    edit = draw_choice(c);
    if (edit) return edit;
    if (draw_name(c, yarn)) edit = changed(c.view.yarn, yarn, "Name");
    if (draw_twist(c, yarn)) edit = changed(c.view.yarn, yarn, "Twist");
    if (draw_plies(c, yarn)) edit = changed(c.view.yarn, yarn, kPliesFacts.label);
    if (const char* what = field_sliders(c, kYarnFields, yarn)) edit = changed(c.view.yarn, yarn, what);
  }
  if (MaybeEdit light = draw_light(c, yarn, strip)) edit = std::move(light);
  return edit;
}

}  // namespace weftlight::views
