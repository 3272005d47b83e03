#include "views/inspector/yarn_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "draft/fibre.h"
#include "draft/yarn_fields.h"
#include "draft/yarn_presets.h"
#include "session/paint.h"
#include "ui/icons.h"
#include "ui/widgets.h"
#include "views/inspector/count_row.h"
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

/// The label of the lobes' field that was changed, or null.
const char* lobe_sliders(const PanelContext& c, Lobes& lobes) {
  const char* label = nullptr;
  for (const YarnField<Lobes>& field : kLobeFields)
    if (field_slider(c, field.facts, lobes.*field.member)) label = field.facts.label;
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
  row_label(c, "Hand", "Z twist leans like the middle stroke of the letter Z, S twist like that of S");
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

/// What it is spun from: its light as that fibre's ready yarn has it.
bool draw_fibre(PanelContext& c, Yarn& yarn) {
  row_label(c, "Fibre", "What it is spun from: sets how it shines and how hairy it is; thickness and twist stay");
  ImGui::SetNextItemWidth(-FLT_MIN);
  const int fibre = fibre_of(yarn);
  const auto ready = yarn_presets();
  if (!begin_combo(c, "yarn.fibre", ready[static_cast<size_t>(fibre)].name.c_str())) return false;
  bool chosen = false;
  for (int i = 0; i < static_cast<int>(ready.size()); ++i) {
    const std::string& name = ready[static_cast<size_t>(i)].name;
    if (ImGui::Selectable(name.c_str(), i == fibre)) yarn = with_fibre(yarn, i), chosen = true;
    c.map.add_item("yarn.fibre:" + name);
  }
  end_combo();
  return chosen;
}

/// How each fibre is shaped: its light alone.
bool draw_cross_section(PanelContext& c, Yarn& yarn) {
  row_label(c, "Cross-section",
            "What a fibre looks like where it is cut. Trilobal glitters, cotton's bean is duller, flat film flashes; "
            "the flatter, the paler its inner glow");
  ImGui::SetNextItemWidth(-FLT_MIN);
  const size_t now = static_cast<size_t>(cross_section(yarn));
  if (!begin_combo(c, "yarn.section", kCrossSectionNames[now])) return false;
  bool chosen = false;
  for (size_t i = 0; i < kCrossSectionNames.size(); ++i) {
    if (ImGui::Selectable(kCrossSectionNames[i], i == now))
      yarn = with_cross_section(yarn, static_cast<CrossSection>(i)), chosen = true;
    c.map.add_item(std::string("yarn.section:") + kCrossSectionNames[i]);
  }
  end_combo();
  return chosen;
}

bool draw_lustre(PanelContext& c, Yarn& yarn) {
  float bright = lustre(yarn);
  if (!field_slider(c, kLustreFacts, bright)) return false;
  yarn = with_lustre(yarn, bright);
  return true;
}

bool draw_field(PanelContext& c, const YarnField<Yarn>& field, Yarn& yarn) {
  float value = yarn.*field.member;
  if (!field_slider(c, field.facts, value)) return false;
  if (field.member == &Yarn::hairiness) yarn = with_hairiness(yarn, value);
  else yarn.*field.member = value;
  return true;
}

/// The label of what was changed, or null: of what a weaver turns first, and of what the spinner did.
const char* draw_weavers(PanelContext& c, Yarn& yarn) {
  const char* what = nullptr;
  if (draw_fibre(c, yarn)) what = "Fibre";
  if (draw_cross_section(c, yarn)) what = "Cross-section";
  if (draw_count(c, yarn)) what = "Count";
  if (draw_lustre(c, yarn)) what = kLustreFacts.label;
  const auto first = [](const YarnField<Yarn>& f) {
    return f.member == &Yarn::turns_per_m || f.member == &Yarn::hairiness;
  };
  const auto later = [&](const YarnField<Yarn>& f) {
    return !first(f) && !f.facts.optics && f.member != &Yarn::tex;  // the count has its own row
  };
  for (const YarnField<Yarn>& field : kYarnFields)
    if (first(field) && draw_field(c, field, yarn)) what = field.facts.label;
  if (draw_twist(c, yarn)) what = "Hand";
  if (draw_plies(c, yarn)) what = kPliesFacts.label;
  for (const YarnField<Yarn>& field : kYarnFields)
    if (later(field) && draw_field(c, field, yarn)) what = field.facts.label;
  return what;
}

/// A thread of the yarn in the colour in hand.
void draw_strip(PanelContext& c, const Yarn& yarn, Rgb colour, YarnStrip& strip) {
  const float width = ImGui::GetContentRegionAvail().x, height = c.style.px(kStripHeight);
  ImGui::Image(strip.of(yarn, colour, c.settings.lobe_light_deg, static_cast<int>(width), static_cast<int>(height)),
               {width, height});
  c.map.add_item("yarn.strip");
  tooltip(c, "A thread of this yarn in the colour in hand, under the light of the plot");
}

/// The physical numbers, folded until somebody asks for them.
MaybeEdit draw_optics(PanelContext& c, Yarn& yarn, Rgb colour) {
  if (!section(c, "section.lobes", "Optics", false)) return {};
  const ImVec2 plot = ImGui::GetCursorPos();
  const float width = ImGui::GetContentRegionAvail().x;
  // Kept free: drawn last, so that it shows what the sliders have just become.
  ImGui::Dummy({width, lobes_plot_height(c, width) + ImGui::GetStyle().ItemSpacing.y});
  MaybeEdit edit;
  for (const YarnField<Yarn>& field : kYarnFields)
    if (field.facts.optics && draw_field(c, field, yarn)) edit = changed(c.view.yarn, yarn, field.facts.label);
  if (const char* what = lobe_sliders(c, yarn.lobes)) edit = changed(c.view.yarn, yarn, what);
  row_label(c, "Metallic", "Lurex and metal threads: the shine takes the thread's colour, and there is no body");
  if (ImGui::Checkbox("##metallic", &yarn.lobes.metallic)) edit = changed(c.view.yarn, yarn, "Metallic");
  c.map.add_item("yarn.metallic");
  const ImVec2 after = ImGui::GetCursorPos();
  ImGui::SetCursorPos(plot);
  draw_lobes_plot(c, yarn.lobes, colour);
  ImGui::SetCursorPos(after);
  return edit;
}

/// Of the cloth as a whole, not of the yarn in hand.
MaybeEdit draw_finish(PanelContext& c) {
  if (!section(c, "section.finish", "Finish of the cloth", false)) return {};
  Finish finish = c.design.finish;
  for (const YarnField<Finish>& field : kFinishFields) {
    if (!field_slider(c, field.facts, finish.*field.member)) continue;
    return Edit{std::string("Finish: ").append(field.facts.label), [finish](Design d) {
                  d.finish = finish;
                  return d;
                }};
  }
  return {};
}

}  // namespace

MaybeEdit draw_yarns(PanelContext& c, YarnStrip& strip) {
  Yarn yarn = c.design.yarns[static_cast<size_t>(c.view.yarn)];
  const auto& palette = c.design.draft.palette;
  const Rgb colour = palette[std::min(static_cast<size_t>(std::max(c.view.color, 0)), palette.size() - 1)];
  const ImVec2 picture = ImGui::GetCursorPos();
  // Kept free: drawn last, so that it shows what the sliders have just become.
  ImGui::Dummy({ImGui::GetContentRegionAvail().x, c.style.px(kStripHeight)});
  MaybeEdit edit;
  if (section(c, "section.yarns", "Yarns")) {
    edit = draw_choice(c);
    if (edit) return edit;
    if (draw_name(c, yarn)) edit = changed(c.view.yarn, yarn, "Name");
    if (const char* what = draw_weavers(c, yarn)) edit = changed(c.view.yarn, yarn, what);
  }
  if (MaybeEdit optics = draw_optics(c, yarn, colour)) edit = std::move(optics);
  if (MaybeEdit finish = draw_finish(c)) edit = std::move(finish);
  const ImVec2 after = ImGui::GetCursorPos();
  ImGui::SetCursorPos(picture);
  draw_strip(c, yarn, colour, strip);
  ImGui::SetCursorPos(after);
  return edit;
}

}  // namespace weftlight::views
