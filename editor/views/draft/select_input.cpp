#include "views/draft/select_input.h"

#include "session/editing/selection_state.h"
#include "views/draft/held_layout.h"

namespace weftlight::views {

using design::Design;
using draft::BitGrid, draft::Selection;
using session::Cell, session::DocumentView, session::GridId, session::MaybeEdit, session::SelectDrag,
    session::SelectState, session::Tool, session::bit_grid_of, session::drop_block, session::escape,
    session::hold_block_over, session::holds, session::move_selection, session::select_cells,
    session::selection_between;

namespace {

/// A press of a mouse button, handled after all panels are drawn.
struct Press {
  BitGrid grid;
  Cell at;
  bool shift, ctrl, right;
};

void begin_band(SelectState& s, const Press& p) {
  const bool extends = p.shift && !s.selected.empty() && s.selected.grid == p.grid;
  if (!extends || !holds(s.selected, p.grid, s.anchor)) s.anchor = extends ? Cell{s.selected.a0, s.selected.b0} : p.at;
  s.drag = SelectDrag::kBand;
  select_cells(s, selection_between(p.grid, s.anchor, p.at));
}

void begin_move(SelectState& s, const Design& design, const Press& p) {
  s.drag = SelectDrag::kMove;
  s.grip = {p.at.a - s.selected.a0, p.at.b - s.selected.b0};
  // Copying starts now, so that the original stays wherever the drag goes.
  if (p.ctrl) move_selection(s, design, s.selected.a0, s.selected.b0, true);
}

MaybeEdit press(SelectState& s, const Design& design, const Press& p) {
  if (s.held && !p.right) return drop_block(s, design, p.shift);
  if (s.held) {
    escape(s);
    return {};
  }
  if (!p.at.valid()) return {};
  const bool inside = holds(s.selected, p.grid, p.at);
  if (p.right) {
    if (!inside) select_cells(s, selection_between(p.grid, p.at, p.at)), s.anchor = p.at;
  } else if (inside && s.tool == Tool::kSelect && !p.shift) {
    begin_move(s, design, p);
  } else {
    begin_band(s, p);
  }
  return {};
}

MaybeEdit continue_drag(SelectState& s, const Design& design, BitGrid grid, Cell at) {
  if (s.drag == SelectDrag::kBand) {
    if (const Selection next = selection_between(grid, s.anchor, at); next != s.selected) select_cells(s, next);
  } else if (s.drag == SelectDrag::kMove &&
             !(holds(s.selected, grid, at) && at.a - s.grip.a == s.selected.a0 && at.b - s.grip.b == s.selected.b0)) {
    return move_selection(s, design, at.a - s.grip.a, at.b - s.grip.b, false);
  }
  return {};
}

void show_cursor(DraftContext& c, BitGrid grid, Cell at) {
  const SelectState& s = c.select;
  const bool grips = s.drag == SelectDrag::kMove ||
                     (s.drag == SelectDrag::kNone && s.tool == Tool::kSelect && holds(s.selected, grid, at));
  if (grips && !s.held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  else c.frame.crosshair = true;
}

void handle_press(DraftContext& c, BitGrid grid, Cell at) {
  const ImGuiIO& io = ImGui::GetIO();
  const Press p{grid, at, io.KeyShift, io.KeyCtrl, ImGui::IsMouseDown(ImGuiMouseButton_Right)};
  c.frame.selection_menu = p.right && at.valid() && !c.select.held;
  c.wanted.gesture([p](DocumentView& v, const Design& design) { return press(v.select, design, p); });
}

}  // namespace

bool selects(const DraftContext& c, const GridPane& pane) {
  const SelectState& s = c.select;
  if (!bit_grid_of(pane.id) || c.drawing.stroke.grid != GridId::kNone || c.drawing.shape) return false;
  return s.held || s.tool == Tool::kSelect || s.drag != SelectDrag::kNone || ImGui::GetIO().KeyCtrl;
}

void select_input(DraftContext& c, const GridPane& pane) {
  const SelectState& s = c.select;
  const BitGrid grid = *bit_grid_of(pane.id);
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 hand = hand_at(c.style);
  const Cell at = pane.at(hand), closest = pane.nearest(hand);
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  if (!active && !hovered) return;
  if (s.held && hovered && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || ImGui::IsItemActivated()))
    c.wanted.change_view([=](DocumentView& v) { hold_block_over(v.select, grid, at); });
  if (ImGui::IsItemActivated()) handle_press(c, grid, at);
  else if (active && s.drag != SelectDrag::kNone && s.selected.grid == grid && closest.valid())
    c.wanted.gesture(
        [=](DocumentView& v, const Design& design) { return continue_drag(v.select, design, grid, closest); });
  show_cursor(c, grid, at);
}

}  // namespace weftlight::views
