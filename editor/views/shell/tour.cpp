#include "views/shell/tour.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "base/text.h"
#include "session/shown_keys.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {

using base::mark, base::tr;
using session::Settings, session::shown_keys;
using ui::UiControl, ui::UiGrid, ui::UiMap, ui::push_font, ui::text_button;

namespace {

constexpr float kWidth = 300, kGap = 14;  // pixels at 96 dpi

struct Step {
  const char* control;       // name of a control or grid in the map
  const char *title, *text;  // marked texts; {id}: the shortcut of an action
};
constexpr Step kSteps[kTourSteps] = {
    {"threading", mark("Paint the draft"),
     mark("Click or drag in the threading, the tie-up, the treadling or the drawdown itself: the cloth follows at "
          "once. A drag from a filled cell clears cells, and so does the right button. {undo} undoes any step.")},
    {"view", mark("See it as cloth"),
     mark("Drag to turn the cloth, use the wheel to zoom in down to single yarns, and drag with the right button to "
          "move the light.")},
    {"palette:1", mark("Colours and yarns"),
     mark("Choose a colour, then drag along the colour bars of warp and weft. The tabs above have the yarns, the drape "
          "and light of the cloth, and the analysis of the weave.")},
    {"tool:Select", mark("Edit selections"),
     mark("The select tool ({tool_select}) selects any rectangle: copy, mirror, rotate or repeat it; a right click "
          "shows all commands. Drag along the thread numbers to select whole ends or picks.")},
    {"menu:Library", mark("Where to start"),
     mark("The library has drafts and complete cloths; {new} starts from a weave. {commands} finds any command by its "
          "name, and {keys} lists the shortcuts.")},
};

/// The shortcut, or the place in the menus: "Edit, Undo".
std::string shortcut_or_menu(std::span<const ActionItem> items, std::string_view id) {
  for (const ActionItem& item : items) {
    if (item.id != id) continue;
    return item.shortcut.empty() ? tr(item.menu.c_str()) + (", " + item.label.substr(0, item.label.find(':')))
                                 : shown_keys(item.shortcut);
  }
  return std::string(id);
}

struct Rect {
  ImVec2 a, b;
};

std::optional<Rect> place_of(const UiMap& map, const std::string& control) {
  for (const UiControl& item : map.controls)
    if (item.name == control) return Rect{{item.x, item.y}, {item.x + item.w, item.y + item.h}};
  for (const UiGrid& g : map.grids) {
    if (g.name != control) continue;
    const auto width = static_cast<float>(g.count_a), height = static_cast<float>(g.count_b);
    const float x = g.origin[0] + g.step_a[0] * (width - 1), y = g.origin[1] + g.step_b[1] * (height - 1);
    return Rect{{std::min(x, g.origin[0]), std::min(y, g.origin[1])},
                {std::max(x, g.origin[0]), std::max(y, g.origin[1])}};
  }
  return {};
}

/// The part within the window: a grid may go on beyond it.
Rect in_window(Rect r, float margin) {
  const ImGuiViewport* view = ImGui::GetMainViewport();
  const ImVec2 low{view->Pos.x + margin, view->Pos.y},
      high{view->Pos.x + view->Size.x - margin, view->Pos.y + view->Size.y};
  const auto inside = [&](ImVec2 p) {
    return ImVec2{std::clamp(p.x, low.x, std::max(low.x, high.x)), std::clamp(p.y, low.y, std::max(low.y, high.y))};
  };
  return {inside(r.a), inside(r.b)};
}

/// Position beside the control, within the window: below it, to its left, or over its middle.
ImVec2 card_at(const PanelContext& c, const Rect& r, ImVec2 size) {
  const ImGuiViewport* view = ImGui::GetMainViewport();
  const float gap = c.style.px(kGap);
  const ImVec2 low{view->WorkPos.x + gap, view->WorkPos.y + gap};
  const ImVec2 high{view->WorkPos.x + view->WorkSize.x - size.x - gap,
                    view->WorkPos.y + view->WorkSize.y - size.y - gap};
  ImVec2 at{(r.a.x + r.b.x - size.x) / 2, r.b.y + gap};
  if (at.y > high.y) at = {r.a.x - size.x - gap, (r.a.y + r.b.y - size.y) / 2};
  if (at.x < low.x && r.b.y + gap > high.y) at = {(r.a.x + r.b.x - size.x) / 2, (r.a.y + r.b.y - size.y) / 2};
  return {std::max(low.x, std::min(at.x, high.x)), std::max(low.y, std::min(at.y, high.y))};
}

void go_to(PanelContext& c, int step) {
  c.wanted.change_settings([step](Settings& s) {
    if (step < kTourSteps) s.tour = step;
    else leave_tour(s);
  });
}

void draw_dots(const PanelContext& c, int step) {
  const float r = c.style.px(3), apart = c.style.px(12);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float y = at.y + ImGui::GetFrameHeight() / 2;
  for (int i = 0; i < kTourSteps; ++i)
    ImGui::GetWindowDrawList()->AddCircleFilled({at.x + r + apart * static_cast<float>(i), y}, r,
                                                i == step ? c.style.color.accent : c.style.color.line_strong);
}

void draw_card(PanelContext& c, std::span<const ActionItem> items, int step) {
  const Step& s = kSteps[step];
  push_font(c.style.font.bold);
  ImGui::TextUnformatted(tr(s.title));
  ImGui::PopFont();
  ImGui::PushTextWrapPos(c.style.px(kWidth - 16));
  ImGui::TextUnformatted(with_keys(tr(s.text), items).c_str());
  ImGui::PopTextWrapPos();
  ImGui::Dummy({c.style.px(kWidth - 32), c.style.px(2)});
  draw_dots(c, step);
  const bool last = step + 1 == kTourSteps;
  const char *skip = tr("Skip"), *next = last ? tr("Done") : tr("Next");
  const auto width = [](const char* label) {
    return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
  };
  const float before = last ? 0 : width(skip) + ImGui::GetStyle().ItemSpacing.x;
  ImGui::SetCursorPosX(c.style.px(kWidth - 19) - width(next) - before);
  if (!last) {
    ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.muted);
    if (text_button(c, "tour.leave", skip, nullptr)) go_to(c, kTourSteps);
    ImGui::PopStyleColor();
    ImGui::SameLine();
  }
  if (text_button(c, "tour.next", next, nullptr)) go_to(c, step + 1);
}

}  // namespace

std::string with_keys(std::string_view words, std::span<const ActionItem> items) {
  std::string text;
  for (size_t at = 0; at < words.size();) {
    const size_t open = std::min(words.find('{', at), words.size()), close = words.find('}', open);
    text += words.substr(at, open - at);
    if (close == std::string_view::npos) break;
    text += shortcut_or_menu(items, words.substr(open + 1, close - open - 1));
    at = close + 1;
  }
  return text;
}

void leave_tour(Settings& settings) {
  settings.tour = -1;
  settings.toured = true;
}

void draw_tour(PanelContext& c, std::span<const ActionItem> items) {
  const int step = c.settings.tour;
  if (step < 0 || step >= kTourSteps) return;
  const ImGuiViewport* view = ImGui::GetMainViewport();
  const ImVec2 middle{view->WorkPos.x + view->WorkSize.x / 2, view->WorkPos.y + view->WorkSize.y / 2};
  const std::optional<Rect> about = place_of(c.map, kSteps[step].control);
  const float round = c.style.px(6), room = c.style.px(6);
  const Rect r = in_window(about.value_or(Rect{middle, middle}), 2 * room);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, c.style.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {c.style.px(16), c.style.px(12)});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, c.style.color.raised);
  ImGui::PushStyleColor(ImGuiCol_Border, c.style.color.accent);
  const ImVec2 size{c.style.px(kWidth), c.style.px(190)};
  ImGui::SetNextWindowPos(card_at(c, r, size));
  ImGui::Begin("Tour", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  draw_card(c, items, step);
  ImGui::End();
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar(3);
  if (about)
    ImGui::GetForegroundDrawList()->AddRect({r.a.x - room, r.a.y - room}, {r.b.x + room, r.b.y + room},
                                            c.style.color.accent, round, 0, c.style.px(2));
}

}  // namespace weftlight::views
