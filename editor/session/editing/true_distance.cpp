#include "session/editing/true_distance.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"

namespace weftlight::session {

using base::arg, base::fill, base::tr;

bool is_calibrated(const Settings& settings, const Screen& screen) { return settings.screens.contains(screen.name); }

float px_a_mm(const Settings& settings, const Screen& screen) {
  constexpr float kUsual = 96 / 25.4f;
  if (const auto found = settings.screens.find(screen.name); found != settings.screens.end()) return found->second;
  return screen.px_a_mm >= kMinPx_a_mm && screen.px_a_mm <= kMaxPx_a_mm ? screen.px_a_mm : kUsual;
}

float true_scale(const Settings& settings) { return settings.eye_to_screen_cm / (100 * settings.seen_from_m); }

float true_view_distance(const Settings& settings, const Screen& screen, float width_px, float height_px) {
  const float pixel_mm = 1 / (px_a_mm(settings, screen) * true_scale(settings));
  return scene::flat_distance_of_pixel(pixel_mm, static_cast<int>(width_px), static_cast<int>(height_px));
}

float stepped_distance_m(float from_m, float steps) {
  return std::clamp(from_m * std::pow(0.88f, steps), kNearestSeen_m, kFurthestSeen_m);
}

std::string distance_text(float m, bool imperial) {
  if (!imperial) return fill(tr("{metres:.2f} m"), arg("metres", m));
  constexpr float kInch_m = 0.0254f;
  const auto inches = static_cast<int>(std::lround(m / kInch_m));
  return fill(tr("{feet} ft {inches} in"), arg("feet", inches / 12), arg("inches", inches % 12));
}

}  // namespace weftlight::session
