#include "views/draft/draft_rulers.h"

#include <algorithm>
#include <vector>

#include "views/common/ruler_bands.h"

namespace weftlight::views {

using draft::System;
using ui::Axis, ui::ruler_marks;

namespace {

/// Edges of the visible threads in mm from the first thread of the draft: one more than threads.
std::vector<double> edges_mm(const Design& design, System system, const Axis& axis) {
  std::vector<double> edges;
  double at = 0;
  for (int i = 0; i < axis.end_visible(); ++i) {
    if (i >= axis.first_visible()) edges.push_back(at);
    at += design::spacing_of(design, system, i);
  }
  edges.push_back(at);
  return edges;
}

void draw_along(ImDrawList* dl, const DraftContext& c, System system, const Axis& axis, const RulerBand& band) {
  const std::vector<double> edges = edges_mm(c.design, system, axis);
  const auto threads = static_cast<double>(edges.size()) - 1, length_mm = edges.back() - edges.front();
  if (threads < 1 || !(length_mm > 0)) return;
  const double px_a_mm = threads * static_cast<double>(axis.pitch) / length_mm;
  const double label_px = static_cast<double>(c.style.px(band.upright ? 20 : 34));
  const auto pixel_of = [&](double mm) {
    const auto next = std::upper_bound(std::next(edges.begin()), std::prev(edges.end()), mm);
    const double low = *std::prev(next), wide = *next - low;
    const int thread = axis.first_visible() + static_cast<int>(next - edges.begin()) - 1;
    const float into = static_cast<float>(wide > 0 ? std::clamp((mm - low) / wide, 0.0, 1.0) : 0.0);
    const float a = axis.low(thread), b = axis.high(thread);
    return axis.reversed ? b - into * (b - a) : a + into * (b - a);
  };
  draw_ruler_band(dl, c, band,
                  ruler_marks({edges.front(), edges.back(), px_a_mm, label_px, static_cast<double>(c.style.px(4)),
                               c.settings.imperial}),
                  pixel_of);
}

}  // namespace

void draw_draft_rulers(ImDrawList* dl, const DraftContext& c, const DraftLayout& l) {
  if (!c.settings.rulers) return;
  const Axis &ends = l.drawdown.x, &picks = l.drawdown.y;
  if (ends.length < 1 || picks.length < 1) return;
  const ImVec2 a = l.tiled_drawdown.min(), b = l.tiled_drawdown.max();
  const float gap = c.style.px(2), wide = c.style.px(kRulerWide), high = c.style.px(kRulerHigh);
  const float top = l.threading_below ? a.y - gap - high : b.y + gap;
  // Numbers may stand out over the ends of the grid by half.
  const float out = c.style.px(10);
  draw_along(dl, c, System::kWarp, ends,
             {{ends.start - out, top}, {ends.start + ends.length + out, top + high}, false, l.threading_below});
  draw_along(dl, c, System::kWeft, picks,
             {{a.x - gap - wide, picks.start - out}, {a.x - gap, picks.start + picks.length + out}, true, false});
  draw_ruler_unit(dl, c, {a.x - gap - wide, top}, {a.x - gap, top + high});
}

}  // namespace weftlight::views
