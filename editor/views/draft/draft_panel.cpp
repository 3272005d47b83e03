#include "views/draft/draft_panel.h"

#include <algorithm>
#include <cmath>

#include "session/paint.h"
#include "session/selection.h"
#include "ui/widgets.h"
#include "views/draft/draft_layout.h"
#include "views/draft/grid_draw.h"
#include "views/draft/select_input.h"
#include "views/draft/selection_draw.h"
#include "views/draft/thread_heads.h"

namespace weftlight::views {
namespace {

bool is_bar(GridId id) { return id == GridId::kWarpColors || id == GridId::kWeftColors; }

Edit stroke_edit(const PanelContext& c, GridId id, Cell from, Cell to) {
  if (is_bar(id))
    return bar_edit(id, from, to, c.work.bar_paint, c.work.bar_paint == BarPaint::kColor ? c.work.color : c.work.yarn);
  // Shift keeps the thread's other shafts or treadles.
  return paint_edit(id, from, to, c.work.stroke.on, !ImGui::GetIO().KeyShift);
}

/// Takes colour (or yarn) of a thread as the one to paint with.
void pick_up(PanelContext& c, GridId id, Cell at) {
  const Threads& t = c.design.draft.threads(id == GridId::kWarpColors ? System::kWarp : System::kWeft);
  const auto thread = static_cast<size_t>(id == GridId::kWarpColors ? at.a : at.b);
  c.work.color = t.color[thread];
  c.work.yarn = t.yarn[thread];
}

MaybeEdit begin_stroke(PanelContext& c, GridId id, Cell at) {
  if (!at.valid()) return {};
  if (is_bar(id) && ImGui::GetIO().KeyAlt) {
    pick_up(c, id, at);
    return {};
  }
  const bool erase = ImGui::IsMouseDown(ImGuiMouseButton_Right);
  c.work.stroke = {id, !erase && !is_on(c.design.draft, c.cells, id, at), at};
  return stroke_edit(c, id, at, at);
}

MaybeEdit go_on_with_stroke(PanelContext& c, const GridPane& pane) {
  const Cell at = pane.nearest(ImGui::GetIO().MousePos), from = c.work.stroke.last;
  if (!at.valid() || at == from) return {};
  c.work.stroke.last = at;
  return stroke_edit(c, pane.id, from, at);
}

MaybeEdit grid_input(PanelContext& c, const GridPane& pane) {
  const ImVec2 a = pane.min(), b = pane.max();
  if (b.x - a.x < 1 || b.y - a.y < 1) return {};
  ImGui::SetCursorScreenPos(a);
  hit_area(grid_name(pane.id), {b.x - a.x, b.y - a.y},
           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  const bool active = ImGui::IsItemActive();
  if (ImGui::IsItemHovered() || active) {
    c.work.hover_grid = pane.id;
    c.work.hover = active ? pane.nearest(ImGui::GetIO().MousePos) : pane.at(ImGui::GetIO().MousePos);
  }
  if (selects(c, pane)) return select_input(c, pane);
  if (chooses_on_bar(c, pane.id)) {
    choose_on_bar(c, pane);
    return {};
  }
  if (ImGui::IsItemActivated()) return begin_stroke(c, pane.id, pane.at(ImGui::GetIO().MousePos));
  if (active && c.work.stroke.grid == pane.id) return go_on_with_stroke(c, pane);
  if (!active && c.work.stroke.grid == pane.id) c.work.stroke = {};
  return {};
}

void zoom(PanelContext& c, const DraftLayout& l, float steps) {
  const float pitch = zoomed_pitch(c.work.pitch, steps);
  const ImVec2 at = ImGui::GetIO().MousePos;
  c.work.scroll_end = scroll_about(l.drawdown.x, std::clamp(at.x, l.drawdown.min().x, l.drawdown.max().x), pitch);
  c.work.scroll_pick = scroll_about(l.drawdown.y, std::clamp(at.y, l.drawdown.min().y, l.drawdown.max().y), pitch);
  c.work.pitch = pitch;
}

/// Moves what the pane shows by pixels to the right and down.
void pan(PanelContext& c, const DraftLayout& l, float dx, float dy) {
  const bool over_shafts = c.work.hover_grid == GridId::kThreading || c.work.hover_grid == GridId::kTieup;
  const bool over_lift = c.work.hover_grid == GridId::kTieup || c.work.hover_grid == l.lift.id;
  const auto move = [](float& scroll, const Axis& axis, float pixels) {
    scroll = clamp_scroll(axis, scroll + (axis.reversed ? pixels : -pixels) / axis.pitch);
  };
  if (over_shafts && l.threading.y.extent() > l.threading.y.length + 1) move(c.work.scroll_shaft, l.threading.y, dy);
  else move(c.work.scroll_pick, l.drawdown.y, dy);
  if (over_lift && l.lift.x.extent() > l.lift.x.length + 1) move(c.work.scroll_treadle, l.lift.x, dx);
  else move(c.work.scroll_end, l.drawdown.x, dx);
}

void navigate(PanelContext& c, const DraftLayout& l) {
  if (!ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem)) return;
  const ImGuiIO& io = ImGui::GetIO();
  constexpr float kWheelPixels = 48;
  if (io.KeyCtrl && io.MouseWheel != 0) zoom(c, l, io.MouseWheel);
  else if (io.KeyShift) pan(c, l, io.MouseWheel * c.style.px(kWheelPixels), 0);
  else pan(c, l, io.MouseWheelH * c.style.px(kWheelPixels), io.MouseWheel * c.style.px(kWheelPixels));
  if (ImGui::IsMouseDown(ImGuiMouseButton_Middle)) pan(c, l, io.MouseDelta.x, io.MouseDelta.y);
}

/// A thin bar that shows and moves the part in sight.
void scrollbar(PanelContext& c, const char* id, const Axis& axis, float& scroll, ImVec2 min, ImVec2 max, bool across) {
  ImGui::SetCursorScreenPos(min);
  hit_area(id, {max.x - min.x, max.y - min.y});
  c.map.add_item(id);
  const float length = across ? max.x - min.x : max.y - min.y;
  const float all = static_cast<float>(axis.count), seen = axis.length / axis.pitch;
  const float grip = std::max(c.style.px(24), length * seen / all);
  const float most = std::max(1e-6f, all - seen), way = length - grip;
  if (ImGui::IsItemActive() && way > 0) {
    const float moved = across ? ImGui::GetIO().MouseDelta.x : ImGui::GetIO().MouseDelta.y;
    scroll = clamp_scroll(axis, scroll + (axis.reversed ? -moved : moved) / way * most);
  }
  const float share = axis.reversed ? 1 - scroll / most : scroll / most;
  const float at = (across ? min.x : min.y) + way * share;
  const ImU32 color = with_alpha(c.style.color.text, ImGui::IsItemHovered() || ImGui::IsItemActive() ? 0.5f : 0.22f);
  const float r = c.style.px(2);
  if (across) ImGui::GetWindowDrawList()->AddRectFilled({at, min.y + r}, {at + grip, max.y - r}, color, r);
  else ImGui::GetWindowDrawList()->AddRectFilled({min.x + r, at}, {max.x - r, at + grip}, color, r);
}

void scrollbars(PanelContext& c, const DraftLayout& l) {
  const ImVec2 a = l.drawdown.min(), b = l.drawdown.max(), lift = l.lift.max(), shafts = l.threading.min();
  const float thick = c.style.px(9), below = b.y + 3;
  if (l.scroll_ends)
    scrollbar(c, "scroll.ends", l.drawdown.x, c.work.scroll_end, {a.x, below}, {b.x, below + thick}, true);
  if (l.scroll_treadles)
    scrollbar(c, "scroll.treadles", l.lift.x, c.work.scroll_treadle, {l.lift.min().x, below}, {lift.x, below + thick},
              true);
  if (l.scroll_picks)
    scrollbar(c, "scroll.picks", l.drawdown.y, c.work.scroll_pick, {l.max.x - thick - 2, a.y}, {l.max.x - 2, b.y},
              false);
  if (l.scroll_shafts)
    scrollbar(c, "scroll.shafts", l.threading.y, c.work.scroll_shaft, {l.max.x - thick - 2, shafts.y},
              {l.max.x - 2, l.threading.max().y}, false);
}

/// A dot at end 1 and pick 1, where reading starts.
void draw_origin(ImDrawList* dl, const PanelContext& c, const DraftLayout& l) {
  if (l.drawdown.x.first_visible() > 0 || l.drawdown.y.first_visible() > 0) return;
  const float x = l.drawdown.x.reversed ? l.drawdown.max().x + c.style.px(5) : l.drawdown.min().x - c.style.px(5);
  dl->AddCircleFilled({x, l.drawdown.min().y - c.style.px(4)}, c.style.px(3), c.style.color.accent);
}

void draw_rulers(ImDrawList* dl, const PanelContext& c, const DraftLayout& l) {
  const GridId g = c.work.hover_grid;
  const bool on_end = g == GridId::kThreading || g == GridId::kDrawdown || g == GridId::kWarpColors;
  const bool on_pick = g == GridId::kDrawdown || g == GridId::kWeftColors || g == l.lift.id;
  const bool on_shaft = g == GridId::kThreading || g == GridId::kTieup;
  const bool on_lift = g == GridId::kTieup || g == l.lift.id;
  const Cell h = c.work.hover;
  draw_ruler_above(dl, c, l.drawdown.x, l.warp_heads.min().y, l.warp_heads.y.length, on_end ? h.a : -1);
  draw_ruler_beside(dl, c, l.drawdown.y, l.weft_heads.min().x + c.style.px(6), on_pick ? h.b : -1);
  draw_ruler_beside(dl, c, l.threading.y, l.threading.max().x + c.style.px(6), on_shaft ? h.b : -1);
  draw_ruler_above(dl, c, l.lift.x, l.threading.min().y - c.style.px(18), c.style.px(16), on_lift ? h.a : -1);
}

void draw_grids(ImDrawList* dl, PanelContext& c, const DraftLayout& l, CellTexture& texture) {
  draw_color_bar(dl, c, l.warp_bar, System::kWarp);
  draw_color_bar(dl, c, l.weft_bar, System::kWeft);
  draw_bits(dl, c, l.threading);
  draw_bits(dl, c, l.lift);
  if (l.lift.id == GridId::kTreadling) draw_bits(dl, c, l.tieup);
  if (draws_cells(c, l.drawdown)) draw_drawdown_cells(dl, c, l.drawdown);
  else dl->AddImage(texture.of(c, l.drawdown), l.drawdown.min(), l.drawdown.max());
  draw_long_floats(dl, c, l.drawdown);
}

}  // namespace

MaybeEdit draw_draft(PanelContext& c, CellTexture& texture) {
  const ImVec2 min = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const DraftLayout l = lay_out_draft(c.design.draft, c.work, c.style, min, {min.x + room.x, min.y + room.y});
  c.work.hover_grid = GridId::kNone;
  c.work.hover = {};
  c.work.select.crosshair = false;
  if (!ImGui::IsAnyMouseDown()) c.work.select.drag = SelectDrag::kNone;
  follow_design(c.work.select, c.design, c.revision);
  MaybeEdit edit;
  for (const GridPane* pane : l.panes()) {
    if (MaybeEdit made = grid_input(c, *pane)) edit = std::move(made);
    c.map.grids.push_back(map_of(*pane));
  }
  choose_by_heads(c, l);
  scrollbars(c, l);
  navigate(c, l);
  ImDrawList* dl = ImGui::GetWindowDrawList();
  draw_grids(dl, c, l, texture);
  draw_chosen(dl, c, l);
  draw_rulers(dl, c, l);
  draw_origin(dl, c, l);
  draw_selection(dl, c, l);
  draw_block_in_hand(dl, c, l);
  draw_hover(dl, c, l);
  return edit;
}

}  // namespace weftlight::views
