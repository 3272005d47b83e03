#include "views/draft/grid_draw.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "session/editing/paint.h"
#include "ui/imgui_compat.h"
#include "ui/pixel_rect.h"
#include "views/common/cell_image.h"
#include "views/draft/leading_marks.h"

namespace weftlight::views {

using design::Design;
using draft::BitMatrix, draft::CellRect, draft::Face, draft::Threads;
using session::BarPaint, session::Cell, session::ClosestWeave, session::DrawdownStyle, session::GridId, session::Report,
    session::is_on;
using ui::PixelRect, ui::Colors, ui::blend, ui::font_size, ui::label_step, ui::reading_color, ui::with_alpha;

namespace {

// Pixels per cell.
constexpr float kLinesFrom = 5;     // from which grid lines do not hide the cells
constexpr float kNumbersFrom = 15;  // from which a number fits
constexpr float kGapsFrom = 8;      // from which gaps between threads do not darken the drawdown

void draw_lines(ImDrawList* dl, const DraftContext& c, const GridPane& pane) {
  const Colors& k = c.style.color;
  const ImVec2 a = pane.min(), b = pane.max();
  const int every = c.settings.heavy_lines;
  const auto color = [&](int i) { return every > 0 && i % every == 0 ? k.line_strong : k.line; };
  if (pane.x.pitch >= kLinesFrom)
    for (int i = pane.x.first_visible(); i <= pane.x.end_visible(); ++i) {
      const float x = pane.x.reversed ? pane.x.high(i) : pane.x.low(i);
      if (x >= a.x && x <= b.x) dl->AddRectFilled({x, a.y}, {x + 1, b.y}, color(i));
    }
  if (pane.y.pitch >= kLinesFrom)
    for (int i = pane.y.first_visible(); i <= pane.y.end_visible(); ++i) {
      const float y = pane.y.reversed ? pane.y.high(i) : pane.y.low(i);
      if (y >= a.y && y <= b.y) dl->AddRectFilled({a.x, y}, {b.x, y + 1}, color(i));
    }
  dl->AddRect({a.x, a.y}, {b.x + 1, b.y + 1}, k.line_strong);
}

void draw_centered(ImDrawList* dl, ImFont* font, ImVec2 middle, ImU32 color, const std::string& text) {
  const ImVec2 size = font->CalcTextSizeA(font_size(font), FLT_MAX, 0, text.c_str());
  dl->AddText(font, font_size(font),
              {static_cast<float>(static_cast<int>(middle.x - size.x / 2 + 0.5f)),
               static_cast<float>(static_cast<int>(middle.y - size.y / 2 + 0.5f))},
              color, text.c_str());
}

/// Low and high pixel of the cells `first` to `end`, exclusive, in either direction of the axis.
float low_of(const Axis& axis, int first, int end) { return std::min(axis.low(first), axis.low(end - 1)); }
float high_of(const Axis& axis, int first, int end) { return std::max(axis.high(first), axis.high(end - 1)); }

/// The inside of a cell, at least one pixel wide.
PixelRect rect_of(const GridPane& p, int a, int b) {
  const float gap_x = p.x.pitch >= kLinesFrom ? 1.0f : 0.0f, gap_y = p.y.pitch >= kLinesFrom ? 1.0f : 0.0f;
  PixelRect box{{p.x.low(a) + gap_x, p.y.low(b) + gap_y}, {p.x.high(a), p.y.high(b)}};
  box.max.x = std::max(box.max.x, box.min.x + 1);
  box.max.y = std::max(box.max.y, box.min.y + 1);
  return box;
}

void draw_tie(ImDrawList* dl, const DraftContext& c, const PixelRect& box) {
  const ImVec2 m = box.middle();
  const float r = (box.max.x - box.min.x) * 0.30f, thick = std::max(1.5f, r * 0.42f);
  if (c.design.draft.rising) {
    dl->AddCircle(m, r, c.style.color.ink, 0, thick);
  } else {
    dl->AddLine({m.x - r, m.y - r}, {m.x + r, m.y + r}, c.style.color.ink, thick);
    dl->AddLine({m.x - r, m.y + r}, {m.x + r, m.y - r}, c.style.color.ink, thick);
  }
}

void draw_bit(ImDrawList* dl, const DraftContext& c, const GridPane& p, int a, int b) {
  const PixelRect box = rect_of(p, a, b);
  if (p.id == GridId::kTieup) return draw_tie(dl, c, box);
  dl->AddRectFilled(box.min, box.max, c.style.color.ink);
  if (std::min(p.x.pitch, p.y.pitch) >= c.style.px(kNumbersFrom)) {
    const int number = p.id == GridId::kThreading ? b : a;
    draw_centered(dl, c.style.font.mono_small, box.middle(), c.style.color.paper, std::to_string(number + 1));
  }
}

/// A thread from above, with a light and a dark edge that separate it from its neighbours.
void draw_thread(ImDrawList* dl, PixelRect box, ImU32 color, bool upright) {
  const float width = upright ? box.max.x - box.min.x : box.max.y - box.min.y;
  dl->AddRectFilled(box.min, box.max, color);
  if (width < 7) return;
  const float edge = std::max(1.0f, static_cast<float>(static_cast<int>(width * 0.16f)));
  const ImU32 dark = blend(color, IM_COL32(0, 0, 0, 255), 0.22f),
              light = blend(color, IM_COL32(255, 255, 255, 255), 0.16f);
  if (upright) {
    dl->AddRectFilled(box.min, {box.min.x + edge, box.max.y}, light);
    dl->AddRectFilled({box.max.x - edge, box.min.y}, box.max, dark);
  } else {
    dl->AddRectFilled(box.min, {box.max.x, box.min.y + edge}, light);
    dl->AddRectFilled({box.min.x, box.max.y - edge}, box.max, dark);
  }
}

/// The first, then every step-th, but none too close to the first.
bool has_label(int i, int step) { return i == 0 || ((i + 1) % step == 0 && i * 4 >= step * 3); }

struct ThreadStyle {
  CrossingColors color;
  float gap;                                  // pixels between threads
  std::vector<float> warp_inset, weft_inset;  // pixels left free on each side of a thinner thread; empty: 0
  float inset(System s, int thread) const {
    const auto& all = s == System::kWarp ? warp_inset : weft_inset;
    return all.empty() ? 0.0f : all[static_cast<size_t>(thread)];
  }
};

/// Fraction of its cell that the thinnest imaginable thread fills; the thickest fills all of it.
constexpr float kMinWidth = 0.3f;

/// Empty if all threads are equally thick.
std::vector<float> insets(const Design& d, System system, float pitch) {
  const Threads& t = d.draft.threads(system);
  std::vector<float> thickness, out;
  float thickest = 0, thinnest = 1e9f;
  for (size_t i = 0; i < t.color.size(); ++i) {
    thickness.push_back(t.thickness_mm[i] >= 0 ? t.thickness_mm[i]
                                               : d.yarns[static_cast<size_t>(t.yarn[i])].diameter_mm);
    thickest = std::max(thickest, thickness.back());
    thinnest = std::min(thinnest, thickness.back());
  }
  if (!(thinnest < thickest)) return out;
  for (const float mm : thickness)
    out.push_back(static_cast<float>(static_cast<int>(0.5f * pitch * (1 - kMinWidth) * (1 - mm / thickest) + 0.5f)));
  return out;
}

ThreadStyle thread_style(const DraftContext& c, const GridPane& p) {
  if (c.settings.drawdown_style == DrawdownStyle::kStructure)
    return {two_colors(c.design.draft, c.style.color.ink, c.style.color.paper), 0, {}, {}};
  const bool threads = c.settings.drawdown_style == DrawdownStyle::kThreads && p.x.pitch >= kGapsFrom;
  if (!threads) return {crossing_colors(c.design), 0, {}, {}};
  return {crossing_colors(c.design), 1, insets(c.design, System::kWarp, p.x.pitch),
          insets(c.design, System::kWeft, p.y.pitch)};
}

/// The warp floats of an end, each drawn as one rectangle as far as its colour goes.
void draw_warp_floats(ImDrawList* dl, const DraftContext& c, const GridPane& p, const ThreadStyle& style, int end) {
  const int last = p.y.end_visible();
  const float inset = style.inset(System::kWarp, end);
  for (int pick = p.y.first_visible(); pick < last;) {
    if (!warp_on_top(c.cells, c.view.face, end, pick)) {
      ++pick;
      continue;
    }
    const ImU32 color = style.color.of(System::kWarp, end, pick);
    int stop = pick + 1;
    while (stop < last && warp_on_top(c.cells, c.view.face, end, stop) &&
           style.color.of(System::kWarp, end, stop) == color)
      ++stop;
    const PixelRect box{{p.x.low(end) + style.gap + inset, low_of(p.y, pick, stop)},
                        {p.x.high(end) - inset, high_of(p.y, pick, stop)}};
    style.gap > 0 ? draw_thread(dl, box, color, true) : dl->AddRectFilled(box.min, box.max, color);
    pick = stop;
  }
}

/// A pick from edge to edge, one rectangle as far as its colour goes.
void draw_pick(ImDrawList* dl, const GridPane& p, const ThreadStyle& style, int pick) {
  const float inset = style.inset(System::kWeft, pick);
  const auto draw = [&](float from, float to, ImU32 color) {
    const PixelRect box{{from, p.y.low(pick) + style.gap + inset}, {to, p.y.high(pick) - inset}};
    style.gap > 0 ? draw_thread(dl, box, color, false) : dl->AddRectFilled(box.min, box.max, color);
  };
  if (style.color.dyed.table(System::kWeft, pick) < 0)
    return draw(p.min().x, p.max().x, style.color.weft[static_cast<size_t>(pick)]);
  const int last = p.x.end_visible();
  for (int end = p.x.first_visible(); end < last;) {
    const ImU32 color = style.color.of(System::kWeft, pick, end);
    int stop = end + 1;
    while (stop < last && style.color.of(System::kWeft, pick, stop) == color) ++stop;
    draw(low_of(p.x, end, stop), high_of(p.x, end, stop), color);
    end = stop;
  }
}

constexpr int kSampledThreads = 8;  // per pixel

/// For threads narrower than a pixel: each pixel is as dark as the fraction of its threads on that shaft or treadle.
void draw_coverage(ImDrawList* dl, const DraftContext& c, const GridPane& p, bool along_x) {
  const Axis& threads = along_x ? p.x : p.y;
  const Axis& loom = along_x ? p.y : p.x;
  const int pixels = static_cast<int>(threads.length);
  // The same threads for every shaft or treadle.
  std::vector<int> sampled(static_cast<size_t>(pixels) * kSampledThreads);
  for (int i = 0; i < pixels * kSampledThreads; ++i)
    sampled[static_cast<size_t>(i)] =
        threads.at(threads.start + (static_cast<float>(i) + 0.5f) / static_cast<float>(kSampledThreads));
  for (int j = loom.first_visible(); j < loom.end_visible(); ++j) {
    const auto draw = [&](int from, int to, float coverage) {
      if (coverage <= 0) return;
      const ImU32 color = blend(c.style.color.paper, c.style.color.ink, coverage);
      const float a = threads.start + static_cast<float>(from), b = threads.start + static_cast<float>(to);
      const float low = loom.low(j) + 1, high = loom.high(j);
      if (along_x) dl->AddRectFilled({a, low}, {b, high}, color);
      else dl->AddRectFilled({low, a}, {high, b}, color);
    };
    float before = -1;
    int begun = 0;
    for (int pixel = 0; pixel < pixels; ++pixel) {
      int on = 0, all = 0;
      for (int k = 0; k < kSampledThreads; ++k) {
        const int thread = sampled[static_cast<size_t>(pixel * kSampledThreads + k)];
        if (thread < 0) continue;
        on += is_on(c.design.draft, c.cells, p.id, along_x ? Cell{thread, j} : Cell{j, thread});
        ++all;
      }
      const float coverage = all == 0 ? 0 : static_cast<float>(on) / static_cast<float>(all);
      if (coverage == before) continue;
      if (before >= 0) draw(begun, pixel, before);
      before = coverage;
      begun = pixel;
    }
    if (before >= 0) draw(begun, pixels, before);
  }
}

}  // namespace

void draw_bits(ImDrawList* dl, const DraftContext& c, const GridPane& p) {
  const ImVec2 a = p.min(), b = p.max();
  dl->PushClipRect(a, {b.x + 1, b.y + 1}, true);
  // A locked grid lies in the panel, as paper that cannot be written on.
  dl->AddRectFilled(a, b, is_locked(c, p.id) ? c.style.color.panel : c.style.color.paper);
  draw_lines(dl, c, p);
  if (std::min(p.x.pitch, p.y.pitch) < 1) {
    draw_coverage(dl, c, p, p.x.pitch < p.y.pitch);
  } else {
    for (int i = p.x.first_visible(); i < p.x.end_visible(); ++i)
      for (int j = p.y.first_visible(); j < p.y.end_visible(); ++j)
        if (is_on(c.design.draft, c.cells, p.id, {i, j})) draw_bit(dl, c, p, i, j);
  }
  dl->PopClipRect();
}

void draw_color_bar(ImDrawList* dl, const DraftContext& c, const GridPane& p, System system) {
  const bool warp = system == System::kWarp;
  const Axis& axis = warp ? p.x : p.y;
  const Threads& threads = c.design.draft.threads(system);
  const ImVec2 a = p.min(), b = p.max();
  dl->PushClipRect(a, {b.x + 1, b.y + 1}, true);
  float drawn = -1e9f;
  for (int i = axis.first_visible(); i < axis.end_visible(); ++i) {
    if (axis.low(i) == drawn && axis.pitch < 1) continue;
    drawn = axis.low(i);
    const ImU32 color = to_u32(c.design.draft.palette[static_cast<size_t>(threads.color[static_cast<size_t>(i)])]);
    const PixelRect box = warp ? rect_of(p, i, 0) : rect_of(p, 0, i);
    dl->AddRectFilled(box.min, box.max, color);
    if (c.drawing.bar_paint == BarPaint::kYarn && axis.pitch >= c.style.px(10))
      draw_centered(dl, c.style.font.mono_small, box.middle(), reading_color(color),
                    std::to_string(threads.yarn[static_cast<size_t>(i)] + 1));
  }
  dl->AddRect(a, {b.x + 1, b.y + 1}, c.style.color.line_strong);
  dl->PopClipRect();
}

namespace {

/// Strokes from corner to corner of the cells of a float: seen without its colour, too.
void draw_hatch(ImDrawList* dl, const DraftContext& c, const GridPane& p, int end, int pick, int stop) {
  constexpr float kHatchFrom = 5;  // pixels a cell
  if (std::min(p.x.pitch, p.y.pitch) < kHatchFrom) return;
  const float thick = p.x.pitch >= 12 ? 1.6f : 1.0f;
  for (int i = pick; i < stop; ++i) {
    const ImVec2 a{p.x.low(end), p.y.high(i)}, b{p.x.high(end), p.y.low(i)};
    dl->AddLine({a.x + 1, a.y + 1}, {b.x + 1, b.y + 1}, with_alpha(c.style.color.paper, 0.8f), thick);
    dl->AddLine(a, b, c.style.color.ink, thick);
  }
}

}  // namespace

void draw_long_floats(ImDrawList* dl, const DraftContext& c, const GridPane& p) {
  if (!c.show_floats || c.report == nullptr || c.report->revision != c.revision) return;
  const BitMatrix& marks = c.view.face == Face::kFront ? c.report->front : c.report->back;
  constexpr float kMinPitch = 1;  // pixels per cell; below, the tint would cover everything
  if (p.x.pitch < kMinPitch || marks.cols() != p.x.count || marks.rows() != p.y.count) return;
  const ImU32 tint = with_alpha(c.style.color.error, 0.55f);
  dl->PushClipRect(p.min(), p.max(), true);
  for (int end = p.x.first_visible(); end < p.x.end_visible(); ++end) {
    for (int pick = p.y.first_visible(); pick < p.y.end_visible();) {
      int stop = pick;
      while (stop < p.y.end_visible() && marks.get(stop, end)) ++stop;
      if (stop > pick) {
        dl->AddRectFilled({p.x.low(end), low_of(p.y, pick, stop)}, {p.x.high(end), high_of(p.y, pick, stop)}, tint);
        draw_hatch(dl, c, p, end, pick, stop);
      }
      pick = stop + 1;
    }
  }
  dl->PopClipRect();
}

namespace {

/// Tints the crossings; if cells are small, outlines their areas instead. The area shown last is always outlined.
void draw_marks(ImDrawList* dl, const DraftContext& c, const GridPane& p, const BitMatrix& differing,
                std::span<const CellRect> places) {
  if (differing.cols() != p.x.count || differing.rows() != p.y.count) return;
  const ImU32 tint = with_alpha(c.style.color.warn, 0.6f);
  constexpr float kMinPitch = 1;  // pixels per cell; below, areas are shown, not crossings
  dl->PushClipRect(p.min(), p.max(), true);
  for (int pick = p.y.first_visible(); pick < p.y.end_visible() && p.x.pitch >= kMinPitch; ++pick)
    for (int end = p.x.first_visible(); end < p.x.end_visible(); ++end) {
      if (!differing.get(pick, end)) continue;
      dl->AddRectFilled({p.x.low(end), p.y.low(pick)}, {p.x.high(end), p.y.high(pick)}, tint);
    }
  for (size_t i = 0; i < places.size(); ++i) {
    const CellRect& at = places[i];
    const bool shown = static_cast<int>(i) == c.differences.place;
    if (!shown && p.x.pitch >= kMinPitch) continue;
    const ImVec2 a{low_of(p.x, at.end0, at.end1), low_of(p.y, at.pick0, at.pick1)};
    const ImVec2 b{high_of(p.x, at.end0, at.end1) + 1, high_of(p.y, at.pick0, at.pick1) + 1};
    dl->AddRect(a, b, c.style.color.warn, 0, 0, shown ? 2.0f : 1.0f);
  }
  dl->PopClipRect();
}

}  // namespace

void draw_differences(ImDrawList* dl, const DraftContext& c, const GridPane& p) {
  if (const ClosestWeave* n = c.differences.closest.get()) return draw_marks(dl, c, p, n->differing, n->places);
  const Report* r = c.report;
  if (!c.differences.other || r == nullptr || r->other != c.differences.other || r->revision != c.revision) return;
  draw_marks(dl, c, p, r->differing, r->places);
}

bool draws_cells(const DraftContext& c, const GridPane& p) { return p.x.pitch >= c.style.px(kLinesFrom); }

void draw_drawdown_cells(ImDrawList* dl, const DraftContext& c, const GridPane& p) {
  const ImVec2 a = p.min(), b = p.max();
  const ThreadStyle style = thread_style(c, p);
  dl->PushClipRect(a, b, true);
  dl->AddRectFilled(a, b, blend(c.style.color.ink, c.style.color.paper, c.style.dark ? 0.9f : 0.15f));
  for (int pick = p.y.first_visible(); pick < p.y.end_visible(); ++pick) draw_pick(dl, p, style, pick);
  for (int end = p.x.first_visible(); end < p.x.end_visible(); ++end) draw_warp_floats(dl, c, p, style, end);
  dl->PopClipRect();
  if (c.settings.drawdown_style == DrawdownStyle::kStructure) draw_lines(dl, c, p);
  dl->AddRect({a.x - 1, a.y - 1}, {b.x + 1, b.y + 1}, c.style.color.line_strong);
}

void draw_ruler_above(ImDrawList* dl, const DraftContext& c, const Axis& axis, float top, float height, int lit) {
  const int step = label_step(axis.pitch, c.style.px(30));
  for (int i = axis.first_visible(); i < axis.end_visible(); ++i) {
    if (!has_label(i, step) && i != lit) continue;
    const float x = (axis.low(i) + axis.high(i)) / 2;
    if (x < axis.start || x > axis.start + axis.length) continue;
    if (i != lit && lit >= 0 && std::abs(static_cast<float>(i - lit)) * axis.pitch < c.style.px(24)) continue;
    draw_centered(dl, c.style.font.mono_small, {x, top + height / 2},
                  i == lit ? c.style.color.accent : c.style.color.muted, std::to_string(i + 1));
  }
}

void draw_ruler_beside(ImDrawList* dl, const DraftContext& c, const Axis& axis, float left, int lit) {
  const int step = label_step(axis.pitch, c.style.px(16));
  ImFont* font = c.style.font.mono_small;
  for (int i = axis.first_visible(); i < axis.end_visible(); ++i) {
    if (!has_label(i, step) && i != lit) continue;
    const float y = (axis.low(i) + axis.high(i)) / 2;
    if (y < axis.start || y > axis.start + axis.length) continue;
    if (i != lit && lit >= 0 && std::abs(static_cast<float>(i - lit)) * axis.pitch < c.style.px(13)) continue;
    dl->AddText(font, font_size(font), {left, static_cast<float>(static_cast<int>(y - font_size(font) / 2))},
                i == lit ? c.style.color.accent : c.style.color.muted, std::to_string(i + 1).c_str());
  }
}

void draw_hover(ImDrawList* dl, const DraftContext& c, const DraftLayout& l) {
  if (!c.frame.hover.cell.valid()) return;
  const auto shares = [](const Axis& a, const Axis& b) { return a.start == b.start && a.count == b.count; };
  const ImU32 band = with_alpha(c.style.color.accent, 0.16f);
  const GridPane* over = nullptr;
  for (const GridPane* p : l.panes())
    if (p->id == c.frame.hover.grid) over = p;
  if (over == nullptr) return;
  const bool bar_x = over->id == GridId::kWarpColors, bar_y = over->id == GridId::kWeftColors;
  for (const GridPane* p : l.panes()) {
    const ImVec2 a = p->min(), b = p->max();
    dl->PushClipRect(a, b, true);
    if (!bar_y && shares(p->x, over->x))
      dl->AddRectFilled({p->x.low(c.frame.hover.cell.a), a.y}, {p->x.high(c.frame.hover.cell.a) + 1, b.y}, band);
    if (!bar_x && shares(p->y, over->y))
      dl->AddRectFilled({a.x, p->y.low(c.frame.hover.cell.b)}, {b.x, p->y.high(c.frame.hover.cell.b) + 1}, band);
    dl->PopClipRect();
  }
  const GridPane& o = *over;
  dl->AddRect({o.x.low(c.frame.hover.cell.a), o.y.low(c.frame.hover.cell.b)},
              {o.x.high(c.frame.hover.cell.a) + 1, o.y.high(c.frame.hover.cell.b) + 1}, c.style.color.accent, 0, 0,
              1.5f);
}

}  // namespace weftlight::views
