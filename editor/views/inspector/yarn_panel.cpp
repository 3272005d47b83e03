#include "views/inspector/yarn_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "design/fibre.h"
#include "design/yarn_fields.h"
#include "design/yarn_presets.h"
#include "session/editing/paint.h"
#include "ui/icons.h"
#include "ui/widgets.h"
#include "views/inspector/count_row.h"
#include "views/inspector/dye_rows.h"
#include "views/inspector/lobes_plot.h"
#include "views/inspector/words_row.h"

namespace weftlight::views {

using base::mark, base::tr;
using design::CrossSection, design::Design, design::FieldFacts, design::Finish, design::Lobes, design::Twist,
    design::Yarn, design::YarnField, design::kCrossSectionNames, design::kFinishFields, design::kLobeFields,
    design::kLustreFacts, design::kPliesFacts, design::kYarnFields, design::fibre_name, design::lustre,
    design::ready_yarns, design::with_cross_section, design::with_fibre, design::with_hairiness, design::with_lustre,
    design::with_new_yarn, design::with_yarn, design::yarn_presets;
using draft::Rgb;
using session::DocumentView, session::Edit;
using ui::begin_combo, ui::end_combo, ui::icon_button, ui::row_label, ui::section, ui::segmented, ui::slider,
    ui::text_button, ui::tooltip;

namespace {

using Panel = ViewContext<DrawingState>;

constexpr float kStripHeight = 84;  // pixels at 96 dpi

/// The slider of a field. True while it changes `value`.
bool field_slider(const PanelContext& c, const FieldFacts& f, float& value) {
  const std::string id = std::string("yarn.").append(f.id);
  const std::string format = figure_format(f);
  return slider(c, {id.c_str(), tr(f.label), f.from, f.to, format.c_str(), tr(f.tip), f.logarithmic, f.low, f.high},
                value);
}

/// The label of the changed field of the lobes, or null.
const char* lobe_sliders(const PanelContext& c, Lobes& lobes) {
  const char* label = nullptr;
  for (const YarnField<Lobes>& field : kLobeFields)
    if (field_slider(c, field.facts, lobes.*field.member)) label = field.facts.label;
  return label;
}

/// `property`: a marked text, which names the edit.
MaybeEdit changed(int index, const Yarn& yarn, const char* property) {
  return Edit{tr(property), [=](Design d) { return with_yarn(std::move(d), index, yarn); }};
}

void activate(PanelContext& c, int yarn) {
  c.wanted.change_view([yarn](DocumentView& v) { v.drawing.yarn = yarn; });
}

/// The edit first: its undo brings back what was active before it.
void add_yarn(PanelContext& c, const Yarn& yarn) {
  c.wanted.add(Edit{tr("Add yarn"), [yarn](Design d) { return with_new_yarn(std::move(d), yarn); }});
  activate(c, static_cast<int>(c.design.yarns.size()));
}

/// The menu of the plus button.
void draw_ready_yarns(Panel& c) {
  if (!ImGui::BeginPopup("yarn presets")) return;
  if (ImGui::MenuItem(tr("Copy of this one"))) add_yarn(c, c.design.yarns[static_cast<size_t>(c.view.yarn)]);
  c.map.add_item("yarn.add:like");
  if (ImGui::MenuItem(tr("From the library\xE2\x80\xA6"))) c.wanted.add_action("yarns.library");
  c.map.add_item("yarn.add:library");
  if (ImGui::MenuItem(tr("Add to the yarn library"))) c.wanted.add_action("yarns.keep");
  c.map.add_item("yarn.keep");
  if (ImGui::MenuItem(tr("Delete this one"), nullptr, false, c.design.yarns.size() > 1))
    c.wanted.add_action("yarns.delete");
  c.map.add_item("yarn.delete");
  ImGui::Separator();
  for (const Yarn& yarn : ready_yarns()) {
    if (ImGui::MenuItem(tr(yarn.name.c_str()))) add_yarn(c, yarn);
    c.map.add_item("yarn.add:" + yarn.name);
  }
  ImGui::EndPopup();
}

/// The list of yarns as a drop-down, and a button for a new one.
void draw_choice(Panel& c) {
  const auto& yarns = c.design.yarns;
  const float add = ImGui::GetFrameHeight() + c.style.px(12);
  row_label(c, tr("Active yarn"),
            tr("The yarn that is edited here, and painted on the colour bars when they paint yarns"));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - add);
  const auto title = [&](int i) {
    return std::to_string(i + 1).append("  ").append(yarns[static_cast<size_t>(i)].name);
  };
  if (begin_combo(c, "yarn.list", title(c.view.yarn).c_str())) {
    for (int i = 0; i < static_cast<int>(yarns.size()); ++i) {
      ImGui::PushID(i);
      if (ImGui::Selectable(title(i).c_str(), i == c.view.yarn)) activate(c, i);
      ImGui::PopID();
      c.map.add_item("yarn:" + std::to_string(i + 1));
    }
    end_combo();
  }
  ImGui::SameLine();
  if (icon_button(c, "yarn.add", icon::kPlus, "+",
                  tr("Add a copy of this yarn, a preset or a yarn from the library; add this one to the library, or "
                     "delete it")))
    ImGui::OpenPopup("yarn presets");
  draw_ready_yarns(c);
}

bool draw_name(PanelContext& c, Yarn& yarn) {
  row_label(c, tr("Name"), tr("Name of the yarn"));
  ImGui::SetNextItemWidth(-FLT_MIN);
  const bool typed = ImGui::InputText("##name", &yarn.name);
  c.map.add_item("yarn.name");
  return typed;
}

bool draw_twist(PanelContext& c, Yarn& yarn) {
  row_label(c, tr("Twist direction"),
            tr("Z twist leans like the middle stroke of the letter Z, S twist like that of S"));
  constexpr const char* kTwists[] = {mark("None"), "S", "Z"};
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

/// The fibre: takes the optics of the usual yarn of that fibre.
bool draw_fibre(PanelContext& c, Yarn& yarn) {
  row_label(c, tr("Fibre"), tr("What the yarn is spun from. Sets lustre and hairiness; thickness and twist are kept"));
  ImGui::SetNextItemWidth(-FLT_MIN);
  if (!begin_combo(c, "yarn.fibre", tr(fibre_name(yarn.fibre)))) return false;
  bool chosen = false;
  for (const Yarn& ready : yarn_presets()) {
    if (ImGui::Selectable(tr(fibre_name(ready.fibre)), ready.fibre == yarn.fibre))
      yarn = with_fibre(yarn, ready.fibre), chosen = true;
    c.map.add_item("yarn.fibre:" + ready.name);
  }
  end_combo();
  return chosen;
}

/// The cross-section of the fibres, which changes only the optics.
bool draw_cross_section(PanelContext& c, Yarn& yarn) {
  row_label(c, tr("Cross-section"),
            tr("Shape of a fibre's section. Trilobal glitters, the bean shape of cotton is duller, flat film flashes; "
               "the flatter, the paler the body colour"));
  ImGui::SetNextItemWidth(-FLT_MIN);
  const size_t now = static_cast<size_t>(yarn.section);
  if (!begin_combo(c, "yarn.section", tr(kCrossSectionNames[now]))) return false;
  bool chosen = false;
  for (size_t i = 0; i < kCrossSectionNames.size(); ++i) {
    if (ImGui::Selectable(tr(kCrossSectionNames[i]), i == now))
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

/// The label of the changed property, or null. What a weaver changes most comes first, then what the spinner decides.
const char* draw_properties(Panel& c, Yarn& yarn) {
  const char* what = nullptr;
  if (draw_fibre(c, yarn)) what = mark("Fibre");
  if (draw_cross_section(c, yarn)) what = mark("Cross-section");
  if (draw_count(c, yarn)) what = mark("Count");
  if (const std::string threads = count_in_draft(c.design, c.view.yarn); !threads.empty())
    draw_words(c, threads, c.style.color.muted,
               tr("The draft gives its threads a thickness of their own, which cloth and plan go by"));
  if (draw_lustre(c, yarn)) what = kLustreFacts.label;
  const auto first = [](const YarnField<Yarn>& f) {
    return f.member == &Yarn::turns_per_m || f.member == &Yarn::hairiness;
  };
  const auto later = [&](const YarnField<Yarn>& f) {
    return !first(f) && !f.facts.optics && f.member != &Yarn::tex;  // the count has its own row
  };
  for (const YarnField<Yarn>& field : kYarnFields)
    if (first(field) && draw_field(c, field, yarn)) what = field.facts.label;
  if (draw_twist(c, yarn)) what = mark("Twist direction");
  if (draw_plies(c, yarn)) what = kPliesFacts.label;
  for (const YarnField<Yarn>& field : kYarnFields)
    if (later(field) && draw_field(c, field, yarn)) what = field.facts.label;
  return what;
}

/// A thread of the yarn in the active colour.
void draw_strip(PanelContext& c, const Yarn& yarn, Rgb colour, YarnStrip& strip) {
  const float width = ImGui::GetContentRegionAvail().x, height = c.style.px(kStripHeight);
  ImGui::Image(strip.of(yarn, colour, c.settings.lobe_light_deg, static_cast<int>(width), static_cast<int>(height)),
               {width, height});
  c.map.add_item("yarn.strip");
  tooltip(c, tr("A thread of this yarn in the active colour, lit as in the plot of its optics"));
}

/// The optical parameters, folded by default.
MaybeEdit draw_optics(Panel& c, Yarn& yarn, Rgb colour) {
  if (!section(c, "section.lobes", tr("Optics"), false)) return {};
  const ImVec2 plot = ImGui::GetCursorPos();
  const float width = ImGui::GetContentRegionAvail().x;
  // The plot is drawn last, so that it shows the new values of the sliders.
  ImGui::Dummy({width, lobes_plot_height(c, width) + ImGui::GetStyle().ItemSpacing.y});
  ImGui::BeginDisabled(yarn.lobes.metallic);
  if (text_button(c, "yarn.optics_from_fibres", tr("Trace the fibres"),
                  tr("Traces the fibres of this yarn and fits roughness across, fibre layers, internal scattering and "
                     "the diffuse part to them; takes about a minute, in which you can go on")))
    c.wanted.add_action("yarns.optics_from_fibres");
  ImGui::EndDisabled();
  MaybeEdit edit;
  for (const YarnField<Yarn>& field : kYarnFields)
    if (field.facts.optics && draw_field(c, field, yarn)) edit = changed(c.view.yarn, yarn, field.facts.label);
  if (const char* what = lobe_sliders(c, yarn.lobes)) edit = changed(c.view.yarn, yarn, what);
  row_label(
      c, tr("Metallic"),
      tr("For Lurex and metal threads: the highlight has the colour of the thread, and there is no diffuse body"));
  if (ImGui::Checkbox("##metallic", &yarn.lobes.metallic)) edit = changed(c.view.yarn, yarn, mark("Metallic"));
  c.map.add_item("yarn.metallic");
  const ImVec2 after = ImGui::GetCursorPos();
  ImGui::SetCursorPos(plot);
  draw_lobes_plot(c, yarn.lobes, colour);
  ImGui::SetCursorPos(after);
  return edit;
}

/// The finish of the whole cloth, not of the active yarn.
MaybeEdit draw_finish(PanelContext& c) {
  if (!section(c, "section.finish", tr("Cloth finish"), false)) return {};
  Finish finish = c.design.finish;
  for (const YarnField<Finish>& field : kFinishFields) {
    if (!field_slider(c, field.facts, finish.*field.member)) continue;
    return Edit{tr(field.facts.label), [finish](Design d) {
                  d.finish = finish;
                  return d;
                }};
  }
  return {};
}

}  // namespace

std::string figure_format(const FieldFacts& field) {
  std::string format = "%." + std::to_string(field.decimals) + "f";
  if (*field.unit) format.append(" ").append(field.unit);
  if (format.ends_with('%')) format += '%';
  return format;
}

MaybeEdit draw_yarns(const PanelContext& panel, const DrawingState& drawing, YarnStrip& strip) {
  Panel c{panel, drawing};
  Yarn yarn = c.design.yarns[static_cast<size_t>(c.view.yarn)];
  const auto& palette = c.design.draft.palette;
  const size_t active = std::min(static_cast<size_t>(std::max(c.view.color, 0)), palette.size() - 1);
  const Rgb colour = palette[active];
  const ImVec2 picture = ImGui::GetCursorPos();
  // The strip is drawn last, so that it shows the new values of the sliders.
  ImGui::Dummy({ImGui::GetContentRegionAvail().x, c.style.px(kStripHeight)});
  MaybeEdit edit;
  if (section(c, "section.yarns", tr("Yarns"))) {
    draw_choice(c);
    if (draw_name(c, yarn)) edit = changed(c.view.yarn, yarn, mark("Name of the yarn"));
    if (const char* what = draw_properties(c, yarn)) edit = changed(c.view.yarn, yarn, what);
  }
  if (draw_dye(c, yarn, colour, palette[(active + 1) % palette.size()])) edit = changed(c.view.yarn, yarn, mark("Dye"));
  if (MaybeEdit optics = draw_optics(c, yarn, colour)) edit = std::move(optics);
  if (MaybeEdit finish = draw_finish(c)) edit = std::move(finish);
  const ImVec2 after = ImGui::GetCursorPos();
  ImGui::SetCursorPos(picture);
  draw_strip(c, yarn, colour, strip);
  ImGui::SetCursorPos(after);
  return edit;
}

}  // namespace weftlight::views
