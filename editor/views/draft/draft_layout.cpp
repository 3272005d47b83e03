#include "views/draft/draft_layout.h"

#include <algorithm>
#include <cmath>

#include "views/common/ruler_bands.h"

namespace weftlight::views {

using draft::ShedControl;
using session::grid_name;
using ui::clamp_scroll;

namespace {

// Pixels at 96 dpi.
constexpr float kMargin = 14, kBar = 16, kGap = 8, kShaftNumbers = 26, kEndRuler = 18, kPickRuler = 38,
                kTreadleNumbers = 16, kScrollbar = 12;
constexpr float kSmallestLoomPitch = 9, kLargestLoomPitch = 28;  // shafts and treadles stay easy to click
constexpr float kLargestFit = 28, kSmallestFit = 4;              // range of the fitted pitch
constexpr float kThreadingShare = 0.42f, kLiftShare = 0.38f;     // at most this fraction of the pane

struct Room {
  float width, height;  // for the grids, without margins, bars and numbers
};

/// What rulers of the cloth take beside and below the drawdown.
struct Rulers {
  float wide = 0, high = 0;
};

Rulers rulers_of(const Style& s, bool on) { return on ? Rulers{s.px(kRulerWide), s.px(kRulerHigh)} : Rulers{}; }

Room room_of(const Style& s, Rulers rulers, ImVec2 min, ImVec2 max) {
  return {max.x - min.x - rulers.wide - s.px(kMargin) * 2 - s.px(kShaftNumbers) - s.px(kGap) - s.pressed_px(kBar) -
              s.px(kPickRuler),
          max.y - min.y - rulers.high - s.px(kMargin) - s.px(kEndRuler) - s.pressed_px(kBar) - s.px(kGap) * 2 -
              s.px(kScrollbar)};
}

float loom_pitch(const Style& s, float pitch) {
  return std::clamp(std::round(pitch), s.px(kSmallestLoomPitch), s.px(kLargestLoomPitch));
}

int lift_columns(const Draft& d) { return d.shed_control == ShedControl::kLiftplan ? d.shafts : d.treadles; }

/// The space that the draft needs at a pitch.
Room needed(const Draft& d, const Style& s, float pitch, Room room) {
  const float loom = loom_pitch(s, pitch);
  const float lift = std::min(static_cast<float>(lift_columns(d)) * loom, room.width * kLiftShare);
  const float shafts = std::min(static_cast<float>(d.shafts) * loom, room.height * kThreadingShare);
  return {pitch * static_cast<float>(d.ends()) + lift, pitch * static_cast<float>(d.picks()) + shafts};
}

/// In whole pixels. Smaller cells would be hard to see: the draft scrolls instead.
float fitting_pitch(const Draft& d, const Style& s, Room room) {
  float pitch = s.px(kLargestFit);
  const auto fits = [&] {
    const Room t = needed(d, s, pitch, room);
    return t.width <= room.width && t.height <= room.height;
  };
  while (pitch > s.px(kSmallestFit) && !fits()) pitch -= 1;
  return pitch;
}

Axis axis(float start, float room, float pitch, float scroll, int count, bool reversed) {
  Axis a{start, 0, pitch, 0, count, reversed};
  a.length = std::max(0.0f, std::min(std::ceil(a.extent()), std::floor(room)));
  a.scroll = clamp_scroll(a, scroll);
  return a;
}

Axis single(float start, float length) { return {start, length, length, 0, 1, false}; }

}  // namespace

std::vector<const GridPane*> DraftLayout::panes() const {
  std::vector<const GridPane*> all{&warp_bar, &threading, &drawdown, &lift, &weft_bar};
  if (lift.id == GridId::kTreadling) all.push_back(&tieup);
  return all;
}

float fitting_width(const Draft& d, const Settings& settings, const Style& s, float min_width, float max_width,
                    float height) {
  const Room room = room_of(s, rulers_of(s, settings.rulers), {0, 0}, {max_width, height});
  const float width = needed(d, s, fitting_pitch(d, s, room), room).width + max_width - room.width;
  return std::clamp(width, min_width, max_width);
}

namespace {

/// The vertical layout.
struct Rows {
  float labels, bar, threading, drawdown;  // upper edges
};

/// Numbers, bar, threading, drawdown; or the reverse, below the ruler and the scroll bar of the ends. `lift`: height of
/// the drawdown, `shafts`: height of the threading.
Rows rows_of(const Style& s, float top, float ruler, float shafts, float lift, bool below) {
  const float labels = s.px(kEndRuler), bar = s.pressed_px(kBar), gap = s.px(kGap);
  if (!below) return {top, top + labels, top + labels + bar + gap, top + labels + bar + gap + shafts + gap};
  const float drawdown = top + ruler + s.px(kScrollbar) + gap, threading = drawdown + lift + gap;
  return {threading + shafts + gap + bar, threading + shafts + gap, threading, drawdown};
}

/// The axis over a longer range, with its cells in the same positions.
Axis extended(Axis a, float start, float length) {
  const float before = a.reversed ? start + length - a.start - a.length : a.start - start;
  a.scroll -= before / a.pitch;
  a.start = start;
  a.length = length;
  return a;
}

}  // namespace

DraftLayout lay_out_draft(const Draft& d, const DraftView& v, const Settings& settings, const Style& s, ImVec2 min,
                          ImVec2 max) {
  const Rulers rulers = rulers_of(s, settings.rulers);
  const Room room = room_of(s, rulers, min, max);
  const bool below = settings.threading_below;
  DraftLayout l;
  l.pitch = v.pitch > 0 ? v.pitch : fitting_pitch(d, s, room);
  const float loom = loom_pitch(s, l.pitch);

  l.min = min;
  l.max = max;
  l.threading_below = below;
  l.ruler_high = rulers.high;
  Axis shafts = axis(0, room.height * kThreadingShare, loom, v.scroll_shaft, d.shafts, !below);
  Axis picks = axis(0, room.height - shafts.length, l.pitch, v.scroll_pick, d.picks(), settings.pick1_bottom);
  const float high = settings.tiled ? std::floor(std::max(picks.length, room.height - shafts.length)) : picks.length;
  const Rows y = rows_of(s, min.y, rulers.high, shafts.length, high, below);
  shafts.start = y.threading;
  picks.start = below ? y.drawdown + high - picks.length : y.drawdown;

  const float x0 = min.x + s.px(kMargin) + rulers.wide;
  const float lift_width = std::min(static_cast<float>(lift_columns(d)) * loom, std::floor(room.width * kLiftShare));
  Axis ends = axis(x0, room.width - lift_width, l.pitch, v.scroll_end, d.ends(), settings.end1_right);
  const float wide = settings.tiled ? std::floor(std::max(ends.length, room.width - lift_width)) : ends.length;
  if (settings.end1_right) ends.start = x0 + wide - ends.length;
  const float lift_x = x0 + wide + s.px(kShaftNumbers);
  const Axis treadles = axis(lift_x, lift_width, loom, v.scroll_treadle, lift_columns(d), false);
  const float weft_x = lift_x + treadles.length + s.px(kGap);

  const bool plan = d.shed_control == ShedControl::kLiftplan;
  l.warp_bar = {GridId::kWarpColors, ends, single(y.bar, s.pressed_px(kBar))};
  l.threading = {GridId::kThreading, ends, shafts};
  l.tieup = {GridId::kTieup, treadles, shafts};
  l.drawdown = {GridId::kDrawdown, ends, picks};
  l.tiled_drawdown = {GridId::kDrawdown, extended(ends, x0, wide), extended(picks, y.drawdown, high)};
  l.lift = {plan ? GridId::kLiftplan : GridId::kTreadling, treadles, picks};
  l.weft_bar = {GridId::kWeftColors, single(weft_x, s.pressed_px(kBar)), picks};
  l.warp_labels = {GridId::kWarpColors, ends, single(y.labels, s.px(kEndRuler))};
  l.weft_labels = {GridId::kWeftColors, single(weft_x + s.pressed_px(kBar) + 1, s.px(kPickRuler)), picks};
  l.scroll_shafts = shafts.extent() > shafts.length + 1;
  l.scroll_treadles = treadles.extent() > treadles.length + 1;
  l.scroll_ends = ends.extent() > ends.length + 1;
  l.scroll_picks = picks.extent() > picks.length + 1;
  return l;
}

void settle(DraftView& v, const DraftLayout& l) {
  const Axis &ends = l.drawdown.x, &picks = l.drawdown.y;
  if (v.pitch <= 0) v.fitted_pitch = l.pitch;
  v.pitch = l.pitch;
  v.scroll_end = ends.scroll, v.scroll_pick = picks.scroll;
  v.scroll_shaft = l.threading.y.scroll, v.scroll_treadle = l.lift.x.scroll;
  v.seen_ends = ends.length / ends.pitch, v.seen_picks = picks.length / picks.pitch;
  v.seen_shafts = l.threading.y.length / l.threading.y.pitch, v.seen_treadles = l.lift.x.length / l.lift.x.pitch;
}

bool is_settled(const DraftView& v, const DraftLayout& l) {
  const Axis &ends = l.drawdown.x, &picks = l.drawdown.y;
  return v.pitch == l.pitch && v.scroll_end == ends.scroll && v.scroll_pick == picks.scroll &&
         v.scroll_shaft == l.threading.y.scroll && v.scroll_treadle == l.lift.x.scroll &&
         v.seen_ends == ends.length / ends.pitch && v.seen_picks == picks.length / picks.pitch &&
         v.seen_shafts == l.threading.y.length / l.threading.y.pitch &&
         v.seen_treadles == l.lift.x.length / l.lift.x.pitch;
}

UiGrid map_of(const GridPane& pane) {
  const auto middle = [](const Axis& a) { return (a.low(0) + a.high(0)) / 2; };
  const auto step = [](const Axis& a) { return a.reversed ? -a.pitch : a.pitch; };
  UiGrid grid{grid_name(pane.id), {}, {}, {}, pane.x.count, pane.y.count};
  grid.origin[0] = middle(pane.x);
  grid.origin[1] = middle(pane.y);
  grid.step_a[0] = step(pane.x);
  grid.step_b[1] = step(pane.y);
  return grid;
}

}  // namespace weftlight::views
