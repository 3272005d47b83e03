#include "views/shell/task_line.h"

#include <imgui.h>

#include <cmath>

#include "base/text.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {

using base::arg, base::fill, base::tr;
using ui::push_font, ui::text_button;

namespace {

std::string text_of(const base::ShownTask& task, const std::string& awaits) {
  if (!awaits.empty()) return awaits;
  const long percent = std::lround(100 * static_cast<double>(task.share));
  if (percent > 0) return fill(tr("{task}: {percent}%"), arg("task", task.name), arg("percent", percent));
  return fill(tr("{task}\xE2\x80\xA6"), arg("task", task.name));
}

}  // namespace

bool draw_task_line(PanelContext& c, const base::ShownTask& task, const std::string& awaits) {
  push_font(c.style.font.small);
  ImGui::TextUnformatted(text_of(task, awaits).c_str());
  c.map.add_item(awaits.empty() ? "task" : "task.awaited");
  bool cancelled = false;
  if (task.can_stop) {
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0, 0, 0, 0));
    const float pad = c.style.finger > 0 ? ImGui::GetStyle().FramePadding.y : c.style.px(1);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {c.style.px(6), pad});
    cancelled =
        text_button(c, "task.cancel", tr("Cancel"), task.sentence.empty() ? task.name.c_str() : task.sentence.c_str());
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
  }
  ImGui::SameLine(0, c.style.px(16));
  ImGui::PopFont();
  return cancelled;
}

}  // namespace weftlight::views
