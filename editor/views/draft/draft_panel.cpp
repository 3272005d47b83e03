#include "views/draft/draft_panel.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "session/editing/paint.h"
#include "session/editing/selection_state.h"
#include "session/editing/typing.h"
#include "ui/widgets.h"
#include "views/draft/draft_layout.h"
#include "views/draft/draft_rulers.h"
#include "views/draft/drag_scroll.h"
#include "views/draft/drawing_tools.h"
#include "views/draft/grid_draw.h"
#include "views/draft/leading_marks.h"
#include "views/draft/select_input.h"
#include "views/draft/selection_draw.h"
#include "views/draft/thread_labels.h"
#include "views/draft/tiled_draw.h"

namespace weftlight::views {

using base::tr;
using design::Design;
using draft::System, draft::Threads;
using session::Cell, session::DraftView, session::GridId, session::MaybeEdit, session::SelectDrag, session::Tool,
    session::accept_number, session::begin_stroke, session::end_drag, session::fit_grown, session::go_on_with_stroke,
    session::grid_name, session::is_on, session::put_cursor, session::zoomed_pitch;
using ui::Axis, ui::clamp_scroll, ui::hit_area, ui::scroll_about, ui::with_alpha;

namespace {

bool is_bar(GridId id) { return id == GridId::kWarpColors || id == GridId::kWeftColors; }

/// Makes colour and yarn of a thread the active ones.
void pick_up(DraftContext& c, GridId id, Cell at) {
  const Threads& t = c.design.draft.threads(id == GridId::kWarpColors ? System::kWarp : System::kWeft);
  const auto thread = static_cast<size_t>(id == GridId::kWarpColors ? at.a : at.b);
  c.wanted.change_view([color = t.color[thread], yarn = t.yarn[thread]](DocumentView& v) {
    v.drawing.color = color;
    v.drawing.yarn = yarn;
  });
}

/// Shift keeps the thread's other shafts or treadles.
bool takes_off_others() { return !ImGui::GetIO().KeyShift; }

void press(DraftContext& c, GridId id, Cell at) {
  if (!at.valid()) return;
  if (is_bar(id) && ImGui::GetIO().KeyAlt) return pick_up(c, id, at);
  const bool erase = ImGui::IsMouseDown(ImGuiMouseButton_Right);
  const bool on = !erase && !is_on(c.design.draft, c.cells, id, at), only = takes_off_others();
  c.wanted.gesture([=](DocumentView& v, const Design& design) { return begin_stroke(v, design, id, at, on, only); });
}

void paint_on(DraftContext& c, Cell to) {
  if (to.valid() && to != c.drawing.stroke.last)
    c.wanted.gesture([to, only = takes_off_others()](DocumentView& v, const Design& design) {
      return go_on_with_stroke(v, design, to, only);
    });
}

/// How to paint there, for the status bar.
const char* paint_hint(GridId id) {
  switch (id) {
    case GridId::kThreading:
      return tr("Drag: paint; Shift: keep the end's other shafts; right: clear; Ctrl+drag: select");
    case GridId::kTreadling:
      return tr("Drag: paint; Shift: keep the pick's other treadles; right: clear; Ctrl+drag: select");
    case GridId::kWarpColors:
    case GridId::kWeftColors:
      return tr("Drag: colour threads; Alt+click: pick the colour; Shift or Ctrl: select threads");
    default:
      return tr("Drag: paint; right: clear; Ctrl+drag: select");
  }
}

/// Says how to use the grid; a pointer over a locked one says that it takes nothing.
void tell_about(DraftContext& c, GridId id) {
  const bool locked = c.select.tool != Tool::kSelect && is_locked(c, id);
  if (locked) {
    c.frame.hint = tr("Locked, because it follows. Unlock it by the padlock or in the Draft menu");
    return ImGui::SetMouseCursor(ImGuiMouseCursor_NotAllowed);
  }
  c.frame.hint = c.select.tool == Tool::kPaint ? paint_hint(id) : tool_hint(c.select.tool);
}

/// A click with the tool that types numbers.
void place_cursor(DraftContext& c, const GridPane& pane, Cell at) {
  if (ImGui::IsItemActivated() && at.valid())
    c.wanted.gesture([grid = pane.id, at](DocumentView& v, const Design& design) {
      MaybeEdit typed = accept_number(v, design);
      put_cursor(v.drawing.cursor, grid, at);
      return typed;
    });
}

void use_tool(DraftContext& c, const GridPane& pane, ImVec2 hand) {
  const bool active = ImGui::IsItemActive();
  if (selects(c, pane)) return select_input(c, pane);
  if (chooses_on_bar(c, pane.id)) return choose_on_bar(c, pane);
  if (draws_shapes(c, pane)) return draw_with_tool(c, pane);
  if (c.select.tool == Tool::kType && !is_bar(pane.id)) return place_cursor(c, pane, pane.at(hand));
  if (ImGui::IsItemActivated()) return press(c, pane.id, pane.at(hand));
  if (active && c.drawing.stroke.grid == pane.id) return paint_on(c, pane.nearest(hand));
  if (!active && c.drawing.stroke.grid == pane.id) c.wanted.change_view([](DocumentView& v) { v.drawing.stroke = {}; });
}

/// True while a button that went down on the grid is down.
bool grid_input(DraftContext& c, const GridPane& pane) {
  const ImVec2 a = pane.min(), b = pane.max();
  if (b.x - a.x < 1 || b.y - a.y < 1) return false;
  ImGui::SetCursorScreenPos(a);
  hit_area(grid_name(pane.id), {b.x - a.x, b.y - a.y},
           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  const bool active = ImGui::IsItemActive();
  const ImVec2 hand = hand_at(c.style);
  if (ImGui::IsItemHovered() || active) {
    c.frame.hover = {pane.id, active ? pane.nearest(hand) : pane.at(hand)};
    tell_about(c, pane.id);
  }
  use_tool(c, pane, hand);
  return active;
}

void zoom(DraftContext& c, const DraftLayout& l, float steps) {
  const Draft& d = c.design.draft;
  const float smallest = std::min(l.pitch, smallest_pitch(c.view, d.ends(), d.picks()));
  const float pitch = std::max(smallest, zoomed_pitch(l.pitch, steps));
  const ImVec2 at = ImGui::GetIO().MousePos;
  const float end = scroll_about(l.drawdown.x, std::clamp(at.x, l.drawdown.min().x, l.drawdown.max().x), pitch);
  const float pick = scroll_about(l.drawdown.y, std::clamp(at.y, l.drawdown.min().y, l.drawdown.max().y), pitch);
  c.wanted.change_view([=](DocumentView& v) {
    v.draft.pitch = pitch;
    v.draft.scroll_end = end;
    v.draft.scroll_pick = pick;
  });
}

using Scroll = float DraftView::*;

void scroll_by(DraftContext& c, Scroll scroll, const Axis& axis, float threads) {
  if (threads != 0)
    c.wanted.change_view([=](DocumentView& v) { v.draft.*scroll = clamp_scroll(axis, v.draft.*scroll + threads); });
}

/// Scrolls the pane's content by pixels to the right and down.
void pan(DraftContext& c, const DraftLayout& l, float dx, float dy) {
  const bool over_shafts = c.frame.hover.grid == GridId::kThreading || c.frame.hover.grid == GridId::kTieup;
  const bool over_lift = c.frame.hover.grid == GridId::kTieup || c.frame.hover.grid == l.lift.id;
  const auto move = [&c](Scroll scroll, const Axis& axis, float pixels) {
    scroll_by(c, scroll, axis, (axis.reversed ? pixels : -pixels) / axis.pitch);
  };
  if (over_shafts && l.threading.y.extent() > l.threading.y.length + 1)
    move(&DraftView::scroll_shaft, l.threading.y, dy);
  else move(&DraftView::scroll_pick, l.drawdown.y, dy);
  if (over_lift && l.lift.x.extent() > l.lift.x.length + 1) move(&DraftView::scroll_treadle, l.lift.x, dx);
  else move(&DraftView::scroll_end, l.drawdown.x, dx);
}

void navigate(DraftContext& c, const DraftLayout& l, HeldLayout& held) {
  if (!ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem)) return;
  const ImGuiIO& io = ImGui::GetIO();
  constexpr float kWheelPixels = 48;
  // What is drawn, selected or chosen may go on where the wheel leads; a stroke would paint all on the way.
  const bool holds = held.is_held(), pans = ImGui::IsMouseDown(ImGuiMouseButton_Middle);
  if (holds && c.drawing.stroke.grid != GridId::kNone) return;
  if (pans || io.MouseWheel != 0 || io.MouseWheelH != 0) held.let_scroll();
  if (io.KeyCtrl && io.MouseWheel != 0) {
    if (!holds) zoom(c, l, io.MouseWheel);
  } else if (io.KeyShift) {
    pan(c, l, io.MouseWheel * c.style.px(kWheelPixels), 0);
  } else {
    pan(c, l, io.MouseWheelH * c.style.px(kWheelPixels), io.MouseWheel * c.style.px(kWheelPixels));
  }
  if (pans) pan(c, l, io.MouseDelta.x, io.MouseDelta.y);
}

/// A thin scroll bar.
void scrollbar(DraftContext& c, const char* id, const Axis& axis, Scroll scroll, ImVec2 min, ImVec2 max, bool across) {
  ImGui::SetCursorScreenPos(min);
  hit_area(id, {max.x - min.x, max.y - min.y});
  c.map.add_item(id);
  const float length = across ? max.x - min.x : max.y - min.y;
  const float all = static_cast<float>(axis.count), seen = axis.length / axis.pitch;
  const float grip = std::min(length, std::max(c.style.px(24), length * seen / all));
  const float most = std::max(1e-6f, all - seen), way = length - grip;
  if (ImGui::IsItemActive() && way > 0) {
    const float moved = across ? ImGui::GetIO().MouseDelta.x : ImGui::GetIO().MouseDelta.y;
    scroll_by(c, scroll, axis, (axis.reversed ? -moved : moved) / way * most);
  }
  const float share = axis.reversed ? 1 - axis.scroll / most : axis.scroll / most;
  const float at = (across ? min.x : min.y) + way * share;
  const ImU32 color = with_alpha(c.style.color.text, ImGui::IsItemHovered() || ImGui::IsItemActive() ? 0.5f : 0.22f);
  const float r = c.style.px(2);
  if (across) ImGui::GetWindowDrawList()->AddRectFilled({at, min.y + r}, {at + grip, max.y - r}, color, r);
  else ImGui::GetWindowDrawList()->AddRectFilled({min.x + r, at}, {max.x - r, at + grip}, color, r);
}

/// True if the pointer is on one of the drawdown's.
bool scrollbars(DraftContext& c, const DraftLayout& l) {
  bool hovered = false;
  const ImVec2 a = l.drawdown.min(), b = l.drawdown.max(), lift = l.lift.max(), shafts = l.threading.min();
  // On the side away from the threading.
  const float thick = c.style.px(9),
              below = l.threading_below ? a.y - 3 - l.ruler_high - thick : b.y + 3 + l.ruler_high;
  if (l.scroll_ends)
    scrollbar(c, "scroll.ends", l.drawdown.x, &DraftView::scroll_end, {a.x, below}, {b.x, below + thick}, true);
  hovered |= l.scroll_ends && (ImGui::IsItemHovered() || ImGui::IsItemActive());
  if (l.scroll_treadles)
    scrollbar(c, "scroll.treadles", l.lift.x, &DraftView::scroll_treadle, {l.lift.min().x, below},
              {lift.x, below + thick}, true);
  if (l.scroll_picks)
    scrollbar(c, "scroll.picks", l.drawdown.y, &DraftView::scroll_pick, {l.max.x - thick - 2, a.y}, {l.max.x - 2, b.y},
              false);
  hovered |= l.scroll_picks && (ImGui::IsItemHovered() || ImGui::IsItemActive());
  if (l.scroll_shafts)
    scrollbar(c, "scroll.shafts", l.threading.y, &DraftView::scroll_shaft, {l.max.x - thick - 2, shafts.y},
              {l.max.x - 2, l.threading.max().y}, false);
  return hovered;
}

/// A dot at end 1 and pick 1, where reading starts.
void draw_origin(ImDrawList* dl, DraftContext& c, const DraftLayout& l) {
  if (l.drawdown.x.first_visible() > 0 || l.drawdown.y.first_visible() > 0) return;
  const float x = l.drawdown.x.reversed ? l.drawdown.max().x + c.style.px(5) : l.drawdown.min().x - c.style.px(5);
  const float y = l.drawdown.y.reversed ? l.drawdown.max().y + c.style.px(4) : l.drawdown.min().y - c.style.px(4);
  dl->AddCircleFilled({x, y}, c.style.px(3), c.style.color.accent);
  const float around = c.style.px(5);
  ImGui::SetCursorScreenPos({x - around, y - around});
  ImGui::Dummy({2 * around, 2 * around});
  c.map.add_item("origin");
  tooltip(c, tr("The draft is read from here: end 1 and pick 1"));
}

void draw_rulers(ImDrawList* dl, const DraftContext& c, const DraftLayout& l) {
  const GridId g = c.frame.hover.grid;
  const bool on_end = g == GridId::kThreading || g == GridId::kDrawdown || g == GridId::kWarpColors;
  const bool on_pick = g == GridId::kDrawdown || g == GridId::kWeftColors || g == l.lift.id;
  const bool on_shaft = g == GridId::kThreading || g == GridId::kTieup;
  const bool on_lift = g == GridId::kTieup || g == l.lift.id;
  const Cell h = c.frame.hover.cell;
  draw_ruler_above(dl, c, l.drawdown.x, l.warp_labels.min().y, l.warp_labels.y.length, on_end ? h.a : -1);
  draw_ruler_beside(dl, c, l.drawdown.y, l.weft_labels.min().x + c.style.px(6), on_pick ? h.b : -1);
  draw_ruler_beside(dl, c, l.threading.y, l.threading.max().x + c.style.px(6), on_shaft ? h.b : -1);
  const float treadles_y =
      l.threading_below ? l.threading.max().y + c.style.px(2) : l.threading.min().y - c.style.px(18);
  draw_ruler_above(dl, c, l.lift.x, treadles_y, c.style.px(16), on_lift ? h.a : -1);
}

void draw_grids(ImDrawList* dl, DraftContext& c, const DraftLayout& l, DraftPictures& pictures) {
  if (c.settings.tiled) draw_tiled(dl, c, l, pictures.tiled);
  draw_color_bar(dl, c, l.warp_bar, System::kWarp);
  draw_color_bar(dl, c, l.weft_bar, System::kWeft);
  draw_bits(dl, c, l.threading);
  draw_bits(dl, c, l.lift);
  if (l.lift.id == GridId::kTreadling) draw_bits(dl, c, l.tieup);
  if (draws_cells(c, l.drawdown)) draw_drawdown_cells(dl, c, l.drawdown);
  else dl->AddImage(pictures.cells.of(c, l.drawdown), l.drawdown.min(), l.drawdown.max());
  draw_long_floats(dl, c, l.drawdown);
  draw_differences(dl, c, l.drawdown);
  if (c.settings.show_repeat) draw_repeat(dl, c, l.drawdown);
  draw_leading(dl, c, l);
}

}  // namespace

void draw_draft(const PanelContext& panel, const DocumentView& view, const Report* report, DraftPictures& pictures) {
  DraftContext c = draft_context(panel, view, report);
  const ImVec2 min = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const DraftLayout l = pictures.held.of(
      lay_out_draft(c.design.draft, c.view, c.settings, c.style, min, {min.x + room.x, min.y + room.y}), c.view,
      hand_of_frame());
  // In its first frame ImGui does not know yet how high the menu bar is: a draft fitted to that room would not fit.
  const bool room_is_known = ImGui::GetFrameCount() > 1;
  if (room_is_known && !is_settled(c.view, l))
    c.wanted.change_view([l, pitch = c.view.pitch](DocumentView& v) {
      if (v.draft.pitch == pitch) settle(v.draft, l);  // else a fit was asked for in this frame
    });
  if (c.view.has_grown && !pictures.held.is_held()) {  // a hand that has not moved yet finds all in its place
    c.wanted.change_view([](DocumentView& v) { fit_grown(v.draft); });
    c.frame.again = true;
  }
  pictures.minimap.apply_input(c, l);
  bool pressed = false;
  for (const GridPane* pane : l.panes()) {
    pressed |= grid_input(c, *pane);
    c.map.grids.push_back(map_of(*pane));
  }
  pressed |= choose_by_labels(c, l);
  if (pressed) pictures.held.hold(l, c.view);
  if (scrollbars(c, l)) pictures.minimap.call();
  navigate(c, l, pictures.held);
  if (scroll_with_drag(c, l)) pictures.held.let_scroll();
  ImDrawList* dl = ImGui::GetWindowDrawList();
  draw_grids(dl, c, l, pictures);
  draw_chosen(dl, c, l);
  draw_rulers(dl, c, l);
  draw_draft_rulers(dl, c, l);
  draw_locks(dl, c, l);
  draw_origin(dl, c, l);
  draw_shape(dl, c, l);
  draw_selection(dl, c, l);
  draw_mirrors(dl, c, l);
  draw_type_cursor(dl, c, l);
  draw_active_block(dl, c, l);
  draw_hover(dl, c, l);
  pictures.minimap.draw(dl, c, l);
  if (!ImGui::IsAnyMouseDown() && c.select.drag != SelectDrag::kNone)
    c.wanted.gesture([](DocumentView& v, const Design& design) {
      end_drag(v, design);
      return MaybeEdit();
    });
}

}  // namespace weftlight::views
