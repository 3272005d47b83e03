#include "views/draft/draft_header.h"

#include <algorithm>
#include <array>
#include <span>

#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {
namespace {

// Pixels at 96 dpi.
constexpr float kMargin = 14, kGap = 10, kTools = 112, kLooks = 214, kToolList = 84, kLookList = 96, kLeastTitle = 60;
constexpr std::array<const char*, 2> kToolWords = {"Paint", "Select"};
constexpr std::array<const char*, 3> kLookWords = {"Threads", "Colour", "Structure"};

/// Side by side, or in a list of its own where there is no room for that.
bool choose(PanelContext& c, const char* id, std::span<const char* const> words, bool listed, float width,
            int& chosen) {
  if (!listed) return segmented(c, id, words, chosen, width);
  ImGui::SetNextItemWidth(width);
  const int before = chosen;
  if (begin_combo(c, id, words[static_cast<size_t>(chosen)])) {
    for (size_t i = 0; i < words.size(); ++i) {
      if (ImGui::Selectable(words[i], static_cast<int>(i) == chosen)) chosen = static_cast<int>(i);
      c.map.add_item(std::string(id) + ":" + words[i]);
    }
    end_combo();
  }
  return chosen != before;
}

void draw_title(PanelContext& c, const std::string& title, float room) {
  ImGui::AlignTextToFramePadding();
  push_font(c.style.font.bold);
  const std::string shown = fitted(title, room);
  ImGui::TextUnformatted(shown.c_str());
  ImGui::PopFont();
  if (shown != title) tooltip(c, title.c_str());
}

}  // namespace

void draw_draft_header(PanelContext& c, const std::string& name) {
  const Style& s = c.style;
  const ImVec2 at = ImGui::GetCursorPos();
  const float width = ImGui::GetWindowWidth(), gap = s.px(kGap), margin = s.px(kMargin);
  const bool listed = width < 2 * margin + s.px(kTools) + gap + s.px(kLooks) + gap + s.px(kLeastTitle);
  const float tools = s.px(listed ? kToolList : kTools), looks = s.px(listed ? kLookList : kLooks);
  const float tools_x = std::max(margin, width - looks - tools - gap - margin);
  const float title_room = tools_x - margin - gap;
  ImGui::SetCursorPos({at.x + margin, at.y + gap});
  if (title_room >= s.px(kLeastTitle) / 2) draw_title(c, c.design.title.empty() ? name : c.design.title, title_room);
  ImGui::SetCursorPos({at.x + tools_x, at.y + gap});
  int tool = static_cast<int>(c.view.select.tool);
  if (choose(c, "tool", kToolWords, listed, tools, tool))
    c.wanted.change_view([tool](DocumentView& v) { v.select.tool = static_cast<Tool>(tool); });
  ImGui::SameLine(0, gap);
  int look = static_cast<int>(c.settings.drawdown_style);
  if (choose(c, "look", kLookWords, listed, looks, look))
    c.wanted.change_settings([look](Settings& s2) { s2.drawdown_style = static_cast<DrawdownStyle>(look); });
  ImGui::SetCursorPos({at.x, at.y + gap + ImGui::GetFrameHeight() + s.px(8)});
}

}  // namespace weftlight::views
