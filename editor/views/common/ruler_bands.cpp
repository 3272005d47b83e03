#include "views/common/ruler_bands.h"

#include "ui/imgui_compat.h"

namespace weftlight::views {

using ui::font_size;

namespace {

constexpr float kLong = 8, kShort = 4;  // marks, pixels at 96 dpi

float whole(float pixel) { return static_cast<float>(static_cast<int>(pixel)); }

void draw_level_mark(ImDrawList* dl, const PanelContext& c, const RulerBand& band, float x, const std::string& text) {
  ImFont* font = c.style.font.mono_small;
  const float edge = band.thing_below ? band.max.y : band.min.y, away = band.thing_below ? -1.0f : 1.0f;
  const float end = edge + away * c.style.px(text.empty() ? kShort : kLong);
  dl->AddLine({x, edge}, {x, end}, c.style.color.muted);
  if (text.empty()) return;
  const ImVec2 size = font->CalcTextSizeA(font_size(font), FLT_MAX, 0, text.c_str());
  const float left = whole(x - size.x / 2), top = band.thing_below ? end - size.y : end;
  if (left < band.min.x || left + size.x > band.max.x) return;
  dl->AddText(font, font_size(font), {left, whole(top)}, c.style.color.muted, text.c_str());
}

void draw_upright_mark(ImDrawList* dl, const PanelContext& c, const RulerBand& band, float y, const std::string& text) {
  ImFont* font = c.style.font.mono_small;
  const float end = band.max.x - c.style.px(text.empty() ? kShort : kLong);
  dl->AddLine({end, y}, {band.max.x, y}, c.style.color.muted);
  if (text.empty()) return;
  const ImVec2 size = font->CalcTextSizeA(font_size(font), FLT_MAX, 0, text.c_str());
  const float top = whole(y - size.y / 2);
  if (top < band.min.y || top + size.y > band.max.y) return;
  dl->AddText(font, font_size(font), {whole(end - size.x - c.style.px(2)), top}, c.style.color.muted, text.c_str());
}

}  // namespace

void draw_ruler_band(ImDrawList* dl, const PanelContext& c, const RulerBand& band, const std::vector<RulerMark>& marks,
                     const std::function<float(double)>& pixel_of) {
  const float first = band.upright ? band.min.y : band.min.x, last = band.upright ? band.max.y : band.max.x;
  for (const RulerMark& mark : marks) {
    const float at = whole(pixel_of(mark.mm)) + 0.5f;
    if (at < first || at > last + 1) continue;
    if (band.upright) draw_upright_mark(dl, c, band, at, mark.text);
    else draw_level_mark(dl, c, band, at, mark.text);
  }
}

void draw_ruler_unit(ImDrawList* dl, const PanelContext& c, ImVec2 min, ImVec2 max) {
  ImFont* font = c.style.font.small;
  const char* unit = ui::ruler_unit(c.settings.imperial);
  const ImVec2 size = font->CalcTextSizeA(font_size(font), FLT_MAX, 0, unit);
  dl->AddText(font, font_size(font), {whole((min.x + max.x - size.x) / 2), whole((min.y + max.y - size.y) / 2)},
              c.style.color.muted, unit);
}

}  // namespace weftlight::views
