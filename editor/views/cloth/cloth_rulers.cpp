#include "views/cloth/cloth_rulers.h"

#include <algorithm>

#include "views/common/ruler_bands.h"

namespace weftlight::views {

using scene::SwatchPoint, scene::flat_centre, scene::flat_pixel_mm;
using ui::ruler_marks, ui::with_alpha;

ClothRulers rulers_of(const PanelContext& c, const ClothView& view) {
  if (!c.settings.rulers || !view.flat || view.camera.azimuth != 0 || view.camera.elevation != 0) return {};
  return {c.style.px(kRulerWide), c.style.px(kRulerHigh)};
}

void draw_cloth_rulers(ImDrawList* dl, const PanelContext& c, const ClothView& view, ClothRulers rulers, ImVec2 a,
                       ImVec2 b) {
  const float width = b.x - a.x, height = b.y - a.y;
  if (rulers.wide <= 0 || width < 2 * rulers.wide || height < 2 * rulers.high) return;
  const design::Scene scene = session::with_orbit(c.design.scene, view.camera);
  const int w = static_cast<int>(width), h = static_cast<int>(height);
  const auto px_a_mm = 1 / static_cast<double>(flat_pixel_mm(scene, w, h));
  const SwatchPoint centre = flat_centre(scene, w, h);
  // Upwards from the lower left corner of the swatch; the ruler counts downwards from the upper one.
  const double x0 = static_cast<double>(a.x + width / 2) - static_cast<double>(centre.x_mm) * px_a_mm;
  const double y0 =
      static_cast<double>(a.y + height / 2) - static_cast<double>(scene::kFlatHeight_mm - centre.y_mm) * px_a_mm;
  const RulerBand level{{a.x + rulers.wide, b.y - rulers.high}, b},
      upright{a, {a.x + rulers.wide, b.y - rulers.high}, true};
  const ImU32 ground = with_alpha(c.style.color.panel, 0.9f);
  dl->AddRectFilled(upright.min, upright.max, ground);
  dl->AddRectFilled({a.x, level.min.y}, b, ground);
  const auto marks = [&](double origin, float from, float to, double most_mm, float label) {
    return ruler_marks({std::max(0.0, (static_cast<double>(from) - origin) / px_a_mm),
                        std::min(most_mm, (static_cast<double>(to) - origin) / px_a_mm), px_a_mm,
                        static_cast<double>(c.style.px(label)), static_cast<double>(c.style.px(4)),
                        c.settings.imperial});
  };
  const auto along = [px_a_mm](double origin) {
    return [=](double mm) { return static_cast<float>(origin + mm * px_a_mm); };
  };
  draw_ruler_band(dl, c, level, marks(x0, level.min.x, level.max.x, static_cast<double>(scene::kFlatWidth_mm), 34),
                  along(x0));
  draw_ruler_band(dl, c, upright,
                  marks(y0, upright.min.y, upright.max.y, static_cast<double>(scene::kFlatHeight_mm), 20), along(y0));
  draw_ruler_unit(dl, c, {a.x, level.min.y}, {level.min.x, b.y});
  c.map.add("view.rulers", a.x, level.min.y, width, rulers.high);
}

}  // namespace weftlight::views
