#include "views/inspector/drape_stiffness_rows.h"

#include <algorithm>
#include <cstdio>

#include "analysis/handle.h"
#include "analysis/units.h"
#include "analysis/yarn_need.h"
#include "base/text.h"
#include "drape/stiffness.h"
#include "files/design_drape.h"
#include "ui/widgets.h"
#include "views/inspector/words_row.h"

namespace weftlight::views {

using analysis::area_weight_text, analysis::short_length_text;
using base::arg, base::fill, base::mark, base::tr;
using drape::drape_stiffness_of;
using session::DrapeStage, session::simulated_drape_edit;
using ui::row_label, ui::segmented, ui::text_button, ui::tooltip;

namespace {

void draw_progress(PanelContext& c, const DrapeState& drape) {
  const char* tip = tr("The cloth is being simulated. Until then the picture shows the generic drape");
  row_label(c, "", tip);
  const float stop_width = ImGui::CalcTextSize(tr("Stop")).x + 4 * ImGui::GetStyle().FramePadding.x;
  const float width = std::max(c.style.px(20), ImGui::GetContentRegionAvail().x - stop_width);
  const float down = (ImGui::GetFrameHeight() - c.style.px(8)) / 2, y = ImGui::GetCursorPosY();
  ImGui::SetCursorPosY(y + down);
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, c.style.color.accent);
  ImGui::ProgressBar(drape.share, {width, c.style.px(8)}, "");
  ImGui::PopStyleColor();
  c.map.add_item("drape.progress");
  tooltip(c, tip);
  ImGui::SameLine();
  ImGui::SetCursorPosY(y);
  if (text_button(c, "drape.stop", tr("Stop"), tr("Stop the simulation; the cloth keeps the generic drape")))
    c.wanted.add_action("drape.stop");
}

void draw_stage(PanelContext& c, const DrapeState& drape) {
  if (drape.stage == DrapeStage::kSimulating) return draw_progress(c, drape);
  const bool failed = drape.stage == DrapeStage::kFailed;
  if (!failed && drape.stage != DrapeStage::kStopped) return;
  if (failed) draw_words(c, drape.problem, c.style.color.error, tr("What went wrong"));
  row_label(c, "", tr("The cloth shows the generic drape"));
  if (text_button(c, "drape.again", tr("Simulate again"), tr("Run the simulation again; takes up to a minute")))
    c.wanted.add_action("drape.again");
}

}  // namespace

std::string stiffness_in_words(const Design& design, Units units) {
  const analysis::ClothHandle handle = analysis::cloth_handle(design);
  if (!(handle.bending_length_mm > 0)) return {};
  constexpr const char* kTexts[] = {mark("Limp: bending length {length}, {weight}"),
                                    mark("Medium: bending length {length}, {weight}"),
                                    mark("Stiff: bending length {length}, {weight}")};
  const char* text = tr(kTexts[static_cast<size_t>(drape_stiffness_of(handle.bending_length_mm))]);
  return fill(text, arg("length", short_length_text(handle.bending_length_mm, units)),
              arg("weight", area_weight_text(analysis::yarn_report(design).g_per_m2, units)));
}

MaybeEdit draw_drape_stiffness(PanelContext& c, const DrapeState& drape) {
  if (!files::can_drape(c.design)) return {};
  row_label(c, tr("Drape"),
            tr("Generic: like any limp, medium or stiff cloth, at once. Simulated: this fabric with its own stiffness, "
               "which takes up to a minute; the result is stored"));
  constexpr const char* kWays[] = {mark("Generic"), mark("Simulated")};
  int way = c.design.scene.simulated_drape ? 1 : 0;
  MaybeEdit edit;
  if (segmented(c, "scene.simulated_drape", kWays, way)) edit = simulated_drape_edit(way == 1);
  const Units units = units_of(c.settings);
  if (const std::string stiffness = stiffness_in_words(c.design, units); !stiffness.empty())
    draw_words(
        c, stiffness, c.style.color.muted,
        fill(tr("Peirce's bending length: how far a strip overhangs before it bends under its own weight. "
                "{charmeuse} is charmeuse, {shirting} shirting, {denim} denim. Computed from yarns and sett; the "
                "weight is that of the plan"),
             arg("charmeuse", short_length_text(12, units)), arg("shirting", short_length_text(19, units)),
             arg("denim", short_length_text(30, units)))
            .c_str());
  draw_stage(c, drape);
  ImGui::Dummy({0, c.style.px(2)});
  return edit;
}

}  // namespace weftlight::views
