#include "views/draft/select_input.h"

#include "session/selection.h"

namespace weftlight::views {
namespace {

MaybeEdit press_with_block(PanelContext& c) {
  SelectState& s = c.work.select;
  if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) {
    escape(s);
    return {};
  }
  return drop_block(s, c.design, ImGui::GetIO().KeyShift);
}

void begin_band(SelectState& s, BitGrid grid, Cell at) {
  const bool extends = ImGui::GetIO().KeyShift && !s.selected.empty() && s.selected.grid == grid;
  if (!extends || !holds(s.selected, grid, s.anchor)) s.anchor = extends ? Cell{s.selected.a0, s.selected.b0} : at;
  s.drag = SelectDrag::kBand;
  select_cells(s, selection_between(grid, s.anchor, at));
}

void begin_move(PanelContext& c, Cell at) {
  SelectState& s = c.work.select;
  s.drag = SelectDrag::kMove;
  s.grip = {at.a - s.selected.a0, at.b - s.selected.b0};
  // A copy leaves now: what it left stays, however the drag goes on.
  if (ImGui::GetIO().KeyCtrl) move_selection(s, c.design, s.selected.a0, s.selected.b0, true);
}

MaybeEdit press(PanelContext& c, BitGrid grid, Cell at) {
  SelectState& s = c.work.select;
  if (s.held) return press_with_block(c);
  if (!at.valid()) return {};
  const bool inside = holds(s.selected, grid, at);
  if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) {
    if (!inside) select_cells(s, selection_between(grid, at, at)), s.anchor = at;
    s.menu_wanted = true;
  } else if (inside && s.tool == Tool::kSelect && !ImGui::GetIO().KeyShift) {
    begin_move(c, at);
  } else {
    begin_band(s, grid, at);
  }
  return {};
}

MaybeEdit go_on(PanelContext& c, BitGrid grid, Cell at) {
  SelectState& s = c.work.select;
  if (!at.valid()) return {};
  if (s.drag == SelectDrag::kBand) {
    if (const Selection next = selection_between(grid, s.anchor, at); next != s.selected) select_cells(s, next);
  } else if (s.drag == SelectDrag::kMove &&
             !(holds(s.selected, grid, at) && at.a - s.grip.a == s.selected.a0 && at.b - s.grip.b == s.selected.b0)) {
    return move_selection(s, c.design, at.a - s.grip.a, at.b - s.grip.b, false);
  }
  return {};
}

void show_cursor(SelectState& s, BitGrid grid, Cell at) {
  const bool grips = s.drag == SelectDrag::kMove ||
                     (s.drag == SelectDrag::kNone && s.tool == Tool::kSelect && holds(s.selected, grid, at));
  if (grips && !s.held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  else s.crosshair = true;
}

}  // namespace

bool selects(const PanelContext& c, const GridPane& pane) {
  const SelectState& s = c.work.select;
  if (!bit_grid_of(pane.id) || c.work.stroke.grid != GridId::kNone) return false;
  return s.held || s.tool == Tool::kSelect || s.drag != SelectDrag::kNone || ImGui::GetIO().KeyCtrl;
}

MaybeEdit select_input(PanelContext& c, const GridPane& pane) {
  SelectState& s = c.work.select;
  const BitGrid grid = *bit_grid_of(pane.id);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  if (!active && !hovered) return {};
  if (hovered && (ImGui::GetIO().MouseDelta.x != 0 || ImGui::GetIO().MouseDelta.y != 0 || ImGui::IsItemActivated()))
    hold_block_over(s, grid, pane.at(mouse));
  MaybeEdit edit;
  if (ImGui::IsItemActivated()) edit = press(c, grid, pane.at(mouse));
  else if (active && s.selected.grid == grid) edit = go_on(c, grid, pane.nearest(mouse));
  show_cursor(s, grid, pane.at(mouse));
  return edit;
}

}  // namespace weftlight::views
