#include "views/draft/tiled_draw.h"

#include <algorithm>
#include <string>

#include "ui/imgui_compat.h"
#include "ui/pixel_rect.h"

namespace weftlight::views {

using design::Repeat;
using ui::PixelRect, ui::font_size, ui::reading_color, ui::with_alpha;

namespace {

constexpr float kDimmed = 0.38f;  // opacity
constexpr float kLinesFrom = 14;  // pixels per repeat from which lines separate the repeats
constexpr float kLabelFrom = 52;  // width of the first repeat, pixels at 96 dpi, from which its size is shown

/// Draws a part of the picture of `pane`.
void draw_part(ImDrawList* dl, ImTextureID picture, const GridPane& pane, ImVec2 a, ImVec2 b) {
  if (a.x >= b.x || a.y >= b.y) return;
  const auto uv = [&](ImVec2 p) {
    return ImVec2{(p.x - pane.x.start) / pane.x.length, (p.y - pane.y.start) / pane.y.length};
  };
  dl->AddImage(picture, a, b, uv(a), uv(b), IM_COL32(255, 255, 255, static_cast<int>(kDimmed * 255)));
}

/// The pixels of the first cells.
PixelRect rect_of(const GridPane& p, int ends, int picks) {
  return {{std::min(p.x.low(0), p.x.low(ends - 1)), std::min(p.y.low(0), p.y.low(picks - 1))},
          {std::max(p.x.high(0), p.x.high(ends - 1)), std::max(p.y.high(0), p.y.high(picks - 1))}};
}

/// Lines where the second and later repeats begin.
void draw_starts(ImDrawList* dl, const DraftContext& c, const GridPane& p, const Repeat& r) {
  const ImVec2 a = p.min(), b = p.max();
  const ImU32 color = with_alpha(c.style.color.accent, 0.55f), halo = with_alpha(c.style.color.paper, 0.45f);
  const auto next = [](int from, int step) { return std::max(1, (from + step - 1) / step) * step; };
  if (static_cast<float>(r.ends) * p.x.pitch >= kLinesFrom)
    for (int i = next(p.x.first_visible(), r.ends); i < p.x.end_visible(); i += r.ends) {
      const float x = p.x.reversed ? p.x.high(i) : p.x.low(i);
      dl->AddRectFilled({x - 1, a.y}, {x + 2, b.y}, halo);
      dl->AddRectFilled({x, a.y}, {x + 1, b.y}, color);
    }
  if (static_cast<float>(r.picks) * p.y.pitch >= kLinesFrom)
    for (int i = next(p.y.first_visible(), r.picks); i < p.y.end_visible(); i += r.picks) {
      const float y = p.y.reversed ? p.y.high(i) : p.y.low(i);
      dl->AddRectFilled({a.x, y - 1}, {b.x, y + 2}, halo);
      dl->AddRectFilled({a.x, y}, {b.x, y + 1}, color);
    }
}

void draw_size(ImDrawList* dl, const DraftContext& c, const GridPane& p, PixelRect box, const Repeat& r) {
  const std::string text = std::to_string(r.ends) + " \xC3\x97 " + std::to_string(r.picks);
  ImFont* font = c.style.font.small;
  const ImVec2 size = font->CalcTextSizeA(font_size(font), FLT_MAX, 0, text.c_str());
  if (box.max.x - box.min.x < c.style.px(kLabelFrom) || box.max.y - box.min.y < size.y * 2) return;
  const float pad = c.style.px(5), gap = c.style.px(4);
  if (box.min.x < p.min().x || box.max.x > p.max().x || box.min.y < p.min().y || box.max.y > p.max().y) return;
  // In the corner opposite to the first crossing.
  const float x = p.x.reversed ? box.min.x + gap : box.max.x - gap - size.x - 2 * pad;
  const float y = p.y.reversed ? box.min.y + gap : box.max.y - gap - size.y - pad;
  dl->AddRectFilled({x, y}, {x + size.x + 2 * pad, y + size.y + pad}, c.style.color.accent, c.style.px(4));
  dl->AddText(font, font_size(font), {x + pad, y + pad / 2}, reading_color(c.style.color.accent), text.c_str());
}

}  // namespace

void draw_tiled(ImDrawList* dl, const DraftContext& c, const DraftLayout& l, CellTexture& texture) {
  const GridPane& all = l.tiled_drawdown;
  const ImVec2 a = all.min(), b = all.max(), p = l.drawdown.min(), q = l.drawdown.max();
  if (all.x.length < 1 || all.y.length < 1 || (p.x <= a.x && p.y <= a.y && q.x >= b.x && q.y >= b.y)) return;
  const ImTextureID picture = texture.of(c, all, true);
  draw_part(dl, picture, all, a, {b.x, p.y});
  draw_part(dl, picture, all, {a.x, q.y}, b);
  draw_part(dl, picture, all, {a.x, p.y}, {p.x, q.y});
  draw_part(dl, picture, all, {q.x, p.y}, {b.x, q.y});
}

void draw_repeat(ImDrawList* dl, const DraftContext& c, const GridPane& p) {
  if (c.report == nullptr || c.report->revision != c.revision) return;
  const Repeat& r = c.report->repeat;
  if (r.ends < 1 || r.picks < 1 || r.ends > p.x.count || r.picks > p.y.count) return;
  dl->PushClipRect({p.min().x - 3, p.min().y - 3}, {p.max().x + 3, p.max().y + 3}, true);
  draw_starts(dl, c, p, r);
  const PixelRect box = rect_of(p, r.ends, r.picks);
  const float thick = c.style.px(2);
  dl->AddRect({box.min.x - 2, box.min.y - 2}, {box.max.x + 3, box.max.y + 3}, c.style.color.paper, 0, 0, thick + 2);
  dl->AddRect({box.min.x - 1, box.min.y - 1}, {box.max.x + 2, box.max.y + 2}, c.style.color.accent, 0, 0, thick);
  draw_size(dl, c, p, box, r);
  dl->PopClipRect();
}

}  // namespace weftlight::views
