#include "views/inspector/drape_stiffness_rows.h"

#include <algorithm>
#include <cstdio>

#include "analysis/handle.h"
#include "drape/stiffness.h"
#include "files/design_drape.h"
#include "ui/widgets.h"
#include "views/inspector/words_row.h"

namespace weftlight::views {
namespace {

void draw_falling(PanelContext& c) {
  constexpr const char* kTip = "The cloth falls, thread by thread; meanwhile the picture shows how its kind hangs";
  row_label(c, "", kTip);
  const float stop_width = ImGui::CalcTextSize("Stop").x + 4 * ImGui::GetStyle().FramePadding.x;
  const float width = std::max(c.style.px(20), ImGui::GetContentRegionAvail().x - stop_width);
  const float down = (ImGui::GetFrameHeight() - c.style.px(8)) / 2, y = ImGui::GetCursorPosY();
  ImGui::SetCursorPosY(y + down);
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, c.style.color.accent);
  ImGui::ProgressBar(c.drape.share, {width, c.style.px(8)}, "");
  ImGui::PopStyleColor();
  c.map.add_item("drape.progress");
  tooltip(c, kTip);
  ImGui::SameLine();
  ImGui::SetCursorPosY(y);
  if (text_button(c, "drape.stop", "Stop", "Leave it; the cloth hangs as its kind does"))
    c.wanted.add_action("drape.stop");
}

void draw_stage(PanelContext& c) {
  if (c.drape.stage == DrapeStage::kFalling) return draw_falling(c);
  const bool failed = c.drape.stage == DrapeStage::kFailed;
  if (!failed && c.drape.stage != DrapeStage::kStopped) return;
  if (failed) draw_words(c, c.drape.problem, c.style.color.error, "What went wrong");
  row_label(c, "", "It hangs as its kind does");
  if (text_button(c, "drape.again", "Drape it again", "Lets it fall once more; takes seconds"))
    c.wanted.add_action("drape.again");
}

}  // namespace

std::string stiffness_in_words(const Design& design) {
  const analysis::ClothHandle hand = analysis::cloth_handle(design);
  if (!(hand.bending_length_mm > 0)) return {};
  constexpr const char* kWords[] = {"Limp", "Medium", "Stiff"};
  char text[96];
  std::snprintf(text, sizeof text, "%s: bends over %.0f mm, weighs %.0f g/m\xC2\xB2",
                kWords[static_cast<size_t>(drape_stiffness_of(hand.bending_length_mm))], hand.bending_length_mm,
                1000 * hand.kg_per_m2);
  return text;
}

MaybeEdit draw_drape_stiffness(PanelContext& c) {
  if (!files::can_drape(c.design)) return {};
  constexpr const char* kTip =
      "As cloths of its kind (limp, medium or stiff) do, at once; or as this cloth does, by its own stiffness, which "
      "takes seconds and is kept";
  row_label(c, "Hangs", kTip);
  constexpr const char* kWays[] = {"As its kind", "As itself"};
  int way = c.design.scene.simulated_drape ? 1 : 0;
  MaybeEdit edit;
  if (segmented(c, "scene.simulated_drape", kWays, way)) edit = simulated_drape_edit(way == 1);
  if (const std::string hang = stiffness_in_words(c.design); !hang.empty())
    draw_words(
        c, hang, c.style.color.muted,
        "Peirce's bending length, by which a strip that juts out sinks under its own weight: 12 mm is charmeuse, "
        "19 shirting, 30 denim. From yarns and sett, as the weight is");
  draw_stage(c);
  ImGui::Dummy({0, c.style.px(2)});
  return edit;
}

}  // namespace weftlight::views
