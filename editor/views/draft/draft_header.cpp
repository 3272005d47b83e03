#include "views/draft/draft_header.h"

#include <algorithm>
#include <array>

#include "base/text.h"
#include "base/utf8.h"
#include "session/shown_keys.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/draft/tool_icons.h"

namespace weftlight::views {

using base::as_utf8, base::mark, base::tr;
using session::DrawdownStyle, session::Settings;
using ui::Style, ui::begin_combo, ui::choices_background, ui::chosen_background, ui::end_combo, ui::fitted,
    ui::hit_area, ui::push_font, ui::segmented, ui::tooltip;

namespace {

// Pixels at 96 dpi.
constexpr float kMargin = 14, kGap = 10, kIconCell = 28, kIcon = 14, kStyles = 214, kToolList = 92, kStyleList = 96,
                kMinTitle = 60;
constexpr std::array<const char*, 3> kStyleNames = {mark("Threads"), mark("Colour"), mark("Structure")};

struct ToolButton {
  const char *name, *action;  // a marked text, also the name in the map
};
/// In the order of the tools.
constexpr std::array kTools = {
    ToolButton{mark("Paint"), "tool_paint"},   ToolButton{mark("Select"), "tool_select"},
    ToolButton{mark("Line"), "tool_line"},     ToolButton{mark("Rectangle"), "tool_rectangle"},
    ToolButton{mark("Filled"), "tool_filled"}, ToolButton{mark("Fill"), "tool_fill"},
    ToolButton{mark("Type"), "tool_type"}};
constexpr std::array kMirrors = {ToolButton{mark("Ends"), "mirror_ends"}, ToolButton{mark("Picks"), "mirror_picks"}};

const ActionItem* item_of(std::span<const ActionItem> items, const char* id) {
  for (const ActionItem& item : items)
    if (item.id == id) return &item;
  return nullptr;
}

std::string tip_of(const ActionItem& item) {
  return item.shortcut.empty() ? item.label : item.label + "   " + session::shown_keys(item.shortcut);
}

/// Buttons side by side on one background, each an action with an icon.
template <class Draw>
void draw_buttons(PanelContext& c, const char* id, std::span<const ToolButton> buttons,
                  std::span<const ActionItem> items, Draw draw_icon) {
  const Style& s = c.style;
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float w = s.pressed_px(kIconCell), h = ImGui::GetFrameHeight(), r = ImGui::GetStyle().FrameRounding;
  dl->AddRectFilled(at, {at.x + w * static_cast<float>(buttons.size()), at.y + h}, choices_background(s.color), r);
  ImGui::PushID(id);
  for (size_t i = 0; i < buttons.size(); ++i) {
    const ActionItem* item = item_of(items, buttons[i].action);
    if (item == nullptr) continue;
    const ImVec2 a{at.x + w * static_cast<float>(i), at.y}, b{a.x + w, a.y + h};
    ImGui::SetCursorScreenPos(a);
    if (hit_area(buttons[i].name, {w, h})) c.wanted.add_action(item->id);
    c.map.add_item(std::string(id) + ":" + buttons[i].name);
    if (item->checked) {
      dl->AddRectFilled({a.x + 2, a.y + 2}, {b.x - 2, b.y - 2}, chosen_background(s), r - 1);
      dl->AddRect({a.x + 2, a.y + 2}, {b.x - 2, b.y - 2}, s.color.line, r - 1);
    }
    const ImU32 color = item->checked ? s.color.accent : ImGui::IsItemHovered() ? s.color.text : s.color.muted;
    draw_icon(dl, i, ImVec2{(a.x + b.x) / 2, (a.y + b.y) / 2}, s.px(kIcon), color);
    tooltip(c, tip_of(*item).c_str());
  }
  ImGui::PopID();
}

void draw_tool_buttons(PanelContext& c, std::span<const ActionItem> items) {
  const ImVec2 at = ImGui::GetCursorPos();
  draw_buttons(c, "tool", kTools, items, [](ImDrawList* dl, size_t i, ImVec2 middle, float size, ImU32 color) {
    draw_tool_icon(dl, static_cast<Tool>(i), middle, size, color);
  });
  ImGui::SetCursorPos({at.x + c.style.pressed_px(kIconCell) * kTools.size() + c.style.px(kGap), at.y});
  draw_buttons(c, "mirror", kMirrors, items, [](ImDrawList* dl, size_t i, ImVec2 middle, float size, ImU32 color) {
    draw_mirror_icon(dl, i == 0, middle, size, color);
  });
}

/// The same as a drop-down list.
void draw_tool_list(PanelContext& c, Tool active, std::span<const ActionItem> items) {
  ImGui::SetNextItemWidth(c.style.px(kToolList));
  if (!begin_combo(c, "tool", tr(kTools[static_cast<size_t>(active)].name))) return;
  const auto draw = [&](const char* id, const ToolButton& button) {
    const ActionItem* item = item_of(items, button.action);
    if (item != nullptr && ImGui::Selectable(item->label.c_str(), item->checked)) c.wanted.add_action(item->id);
    c.map.add_item(std::string(id) + ":" + button.name);
  };
  for (const ToolButton& tool : kTools) draw("tool", tool);
  ImGui::Separator();
  for (const ToolButton& mirror : kMirrors) draw("mirror", mirror);
  end_combo();
}

/// Drawdown styles side by side, or as a drop-down list if `listed`.
void draw_styles(PanelContext& c, bool listed) {
  int style = static_cast<int>(c.settings.drawdown_style);
  if (!listed) {
    segmented(c, "look", kStyleNames, style, c.style.px(kStyles));
  } else {
    ImGui::SetNextItemWidth(c.style.px(kStyleList));
    if (begin_combo(c, "look", tr(kStyleNames[static_cast<size_t>(style)]))) {
      for (size_t i = 0; i < kStyleNames.size(); ++i) {
        if (ImGui::Selectable(tr(kStyleNames[i]), static_cast<int>(i) == style)) style = static_cast<int>(i);
        c.map.add_item(std::string("look:") + kStyleNames[i]);
      }
      end_combo();
    }
  }
  const auto chosen = static_cast<DrawdownStyle>(style);
  if (chosen != c.settings.drawdown_style)
    c.wanted.change_settings([chosen](Settings& s) { s.drawdown_style = chosen; });
}

void draw_title(PanelContext& c, const std::string& title, float room) {
  ImGui::AlignTextToFramePadding();
  push_font(c.style.font.bold);
  const std::string shown = fitted(title, room);
  ImGui::TextUnformatted(shown.c_str());
  ImGui::PopFont();
  c.map.add_item("draft.heading:" + as_utf8(title));
  if (shown != title) tooltip(c, title.c_str());
}

}  // namespace

void draw_draft_header(PanelContext& c, const std::string& title, Tool tool, std::span<const ActionItem> items) {
  const Style& s = c.style;
  const ImVec2 at = ImGui::GetCursorPos();
  const float gap = s.px(kGap), margin = s.px(kMargin), room = ImGui::GetWindowWidth() - 2 * margin;
  const float buttons = s.pressed_px(kIconCell) * (kTools.size() + kMirrors.size()) + gap,
              least_title = s.px(kMinTitle) + gap;
  const bool list_styles = room < least_title + buttons + gap + s.px(kStyles);
  const bool list_tools = room < buttons + gap + s.px(kStyleList);
  const float tools = list_tools ? s.px(kToolList) : buttons, styles = s.px(list_styles ? kStyleList : kStyles);
  const float tools_x = std::max(margin, margin + room - styles - tools - gap);
  const float title_room = tools_x - margin - gap;
  ImGui::SetCursorPos({at.x + margin, at.y + gap});
  if (title_room >= s.px(kMinTitle) / 2) draw_title(c, title, title_room);
  ImGui::SetCursorPos({at.x + tools_x, at.y + gap});
  if (list_tools) draw_tool_list(c, tool, items);
  else draw_tool_buttons(c, items);
  ImGui::SetCursorPos({at.x + tools_x + tools + gap, at.y + gap});
  draw_styles(c, list_styles);
  ImGui::SetCursorPos({at.x, at.y + gap + ImGui::GetFrameHeight() + s.px(8)});
}

}  // namespace weftlight::views
