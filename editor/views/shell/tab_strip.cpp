#include "views/shell/tab_strip.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "base/text.h"
#include "ui/icons.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/shell/action_list.h"

namespace weftlight::views {

using base::tr;
using ui::Colors, ui::fitted, ui::hit_area, ui::icon_button, ui::tooltip, ui::with_alpha;

namespace {

// Pixels at 96 dpi.
constexpr float kHeight = 34, kLead = 14, kCross = 22, kMin = 84, kMax = 230, kRound = 7, kNew = 34, kAbove = 4;

float preferred_width(const PanelContext& c, const Tab& tab) {
  const float text = ImGui::CalcTextSize(tab.name.c_str()).x;
  return std::clamp(text + c.style.px(2 * kLead) + c.style.pressed_px(kCross), c.style.px(kMin), c.style.px(kMax));
}

/// A cross, or a dot for unsaved changes while the pointer is elsewhere.
void draw_mark(const PanelContext& c, ImVec2 middle, bool dot, bool highlighted) {
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const Colors& k = c.style.color;
  if (dot) return dl->AddCircleFilled(middle, c.style.px(4), k.accent);
  const float r = c.style.px(4);
  if (highlighted)
    dl->AddRectFilled({middle.x - 2 * r, middle.y - 2 * r}, {middle.x + 2 * r, middle.y + 2 * r},
                      with_alpha(k.text, 0.12f), c.style.px(4));
  const ImU32 color = highlighted ? k.text : k.muted;
  const ImVec2 m{middle.x - 0.5f, middle.y - 0.5f};
  dl->AddLine({m.x - r, m.y - r}, {m.x + r, m.y + r}, color, 1.4f);
  dl->AddLine({m.x - r, m.y + r}, {m.x + r, m.y - r}, color, 1.4f);
}

/// The background of a tab; that of the shown tab merges with the pane below.
void draw_background(const PanelContext& c, ImVec2 a, ImVec2 b, bool shown, bool hovered) {
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const Colors& k = c.style.color;
  const float r = c.style.px(kRound), gap = c.style.px(3);
  if (shown) {
    dl->AddRectFilled(a, b, k.panel, r, ImDrawFlags_RoundCornersTop);
    dl->AddRectFilled({a.x + r, a.y}, {b.x - r, a.y + c.style.px(2)}, k.accent, c.style.px(1));
  } else if (hovered) {
    dl->AddRectFilled({a.x + gap, a.y + gap}, {b.x - gap, b.y - gap}, with_alpha(k.text, 0.06f), r);
  }
}

struct TabRect {
  ImVec2 a, b;
  size_t index;
};

/// A move to the neighbour's position, once the moved tab would be under the pointer there.
TabRequest dragged(const Tab& tab, const TabRect& p, std::span<const float> edges, float left) {
  const float x = ImGui::GetIO().MousePos.x - left, width = p.b.x - p.a.x;
  const size_t n = p.index;
  if (n + 2 < edges.size() && x > edges[n] + edges[n + 2] - edges[n + 1])
    return {TabRequest::Kind::kMove, tab.id, n + 1};
  if (n > 0 && x < edges[n - 1] + width) return {TabRequest::Kind::kMove, tab.id, n - 1};
  return {};
}

TabRequest draw_tab(PanelContext& c, const Tab& tab, const TabRect& p, bool shown, std::span<const float> edges,
                    float left) {
  const std::string number = std::to_string(p.index + 1);
  const float cross = c.style.pressed_px(kCross), height = p.b.y - p.a.y;
  const ImVec2 mark{p.b.x - cross / 2 - c.style.px(6), (p.a.y + p.b.y) / 2};
  TabRequest requested;
  ImGui::PushID(static_cast<int>(tab.id));
  // Drawn before the tab below it, so that it gets the pointer first.
  ImGui::SetCursorScreenPos({mark.x - cross / 2, mark.y - cross / 2});
  if (hit_area("close", {cross, cross})) requested = {TabRequest::Kind::kClose, tab.id, 0};
  c.map.add_item("tab.close:" + number);
  const bool on_cross = ImGui::IsItemHovered();
  tooltip(c, tab.unsaved ? tr("Close; asks whether to save the changes   Ctrl+W") : tr("Close   Ctrl+W"));
  ImGui::SetCursorScreenPos(p.a);
  hit_area("tab", {p.b.x - p.a.x, height},
           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle | ImGuiButtonFlags_MouseButtonRight);
  c.map.add_item("tab:" + number);
  const bool hovered = ImGui::IsItemHovered() || on_cross;
  if (ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left))
    requested = {TabRequest::Kind::kShow, tab.id, 0};
  else if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left))
    requested = dragged(tab, p, edges, left);
  if (ImGui::IsItemHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Middle))
    requested = {TabRequest::Kind::kClose, tab.id, 0};
  if (ImGui::IsItemHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Right))
    requested = {TabRequest::Kind::kMenu, tab.id, 0};
  tooltip(c, tab.tip.c_str());
  ImGui::PopID();
  draw_background(c, p.a, p.b, shown, hovered);
  const std::string name = fitted(tab.name, mark.x - cross / 2 - p.a.x - c.style.px(kLead));
  ImGui::GetWindowDrawList()->AddText(
      {p.a.x + c.style.px(kLead), static_cast<float>(static_cast<int>((p.a.y + p.b.y - ImGui::GetFontSize()) / 2))},
      shown || hovered ? c.style.color.text : c.style.color.muted, name.c_str());
  if (shown) c.map.add("tab.shown:" + number, p.a.x, p.a.y, p.b.x - p.a.x, height);
  if (tab.unsaved) c.map.add("tab.unsaved:" + number, mark.x - 1, mark.y - 1, 2, 2);
  if (tab.unsaved || hovered || shown) draw_mark(c, mark, tab.unsaved && !hovered, on_cross);
  return requested;
}

/// Scrolls to the shown tab once when it changes; the wheel scrolls freely.
void follow(TabStrip& strip, std::span<const Tab> tabs, uint64_t shown, std::span<const float> edges, float room) {
  if (ImGui::IsWindowHovered()) strip.scroll -= (ImGui::GetIO().MouseWheel + ImGui::GetIO().MouseWheelH) * 60;
  if (strip.shown != shown || strip.count != tabs.size()) {
    for (size_t i = 0; i < tabs.size(); ++i)
      if (tabs[i].id == shown) strip.scroll = std::clamp(strip.scroll, edges[i + 1] - room, edges[i]);
    strip.shown = shown;
    strip.count = tabs.size();
  }
  strip.scroll = std::clamp(strip.scroll, 0.0f, std::max(0.0f, edges.back() - room));
}

}  // namespace

float tab_strip_height(const Style& style, size_t tabs) {
  return tabs > 1 ? style.pressed_px(kHeight - kAbove) + style.px(kAbove) : 0;
}

std::vector<float> tab_edges(std::span<const float> preferred, float room, float min_width) {
  const float all = std::accumulate(preferred.begin(), preferred.end(), 0.0f);
  // Preferred widths up to one maximum for all.
  float max_width = all <= room ? all : min_width;
  for (float step = room; all > room && step > 0.5f; step /= 2) {
    const float sum = std::accumulate(preferred.begin(), preferred.end(), 0.0f,
                                      [&](float s, float w) { return s + std::min(w, max_width + step); });
    if (sum <= room) max_width += step;
  }
  std::vector<float> edges{0};
  for (const float w : preferred)
    edges.push_back(edges.back() + static_cast<float>(static_cast<int>(std::max(min_width, std::min(w, max_width)))));
  return edges;
}

TabRequest draw_tab_strip(PanelContext& c, std::span<const Tab> tabs, uint64_t shown, TabStrip& strip) {
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  ImDrawList* dl = ImGui::GetWindowDrawList();
  dl->AddRectFilled(at, {at.x + size.x, at.y + size.y}, c.style.color.window);
  std::vector<float> preferred;
  for (const Tab& tab : tabs) preferred.push_back(preferred_width(c, tab));
  const float room = std::max(1.0f, size.x - c.style.px(kNew + kLead)), start = at.x + c.style.px(6);
  const std::vector<float> edges = tab_edges(preferred, room, c.style.px(kMin));
  follow(strip, tabs, shown, edges, room);
  const float left = start - strip.scroll, top = at.y + c.style.px(kAbove);
  TabRequest requested;
  ImGui::PushClipRect({start, at.y}, {start + room, at.y + size.y}, true);
  for (size_t i = 0; i < tabs.size(); ++i) {
    const TabRect place{{left + edges[i], top}, {left + edges[i + 1], at.y + size.y}, i};
    if (place.b.x < start || place.a.x > start + room) continue;
    const TabRequest own = draw_tab(c, tabs[i], place, tabs[i].id == shown, edges, left);
    if (own.kind != TabRequest::Kind::kNone) requested = own;
  }
  ImGui::PopClipRect();
  const float side = ImGui::GetFrameHeight();
  ImGui::SetCursorScreenPos({std::min(left + edges.back(), start + room) + c.style.px(4), at.y + (size.y - side) / 2});
  ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.muted);
  if (icon_button(c, "tab.new", icon::kPlus, "+", tr("New draft   Ctrl+N"))) c.wanted.add_action("new");
  ImGui::PopStyleColor();
  return requested;
}

std::string draw_tab_menu(const PanelContext& c, std::span<const ActionItem> items, TabStrip& strip) {
  return draw_context_menu(c, items, &ActionItem::on_tab, "tab_menu", std::exchange(strip.menu_due, false));
}

}  // namespace weftlight::views
