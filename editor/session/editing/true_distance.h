#pragma once
// The flat swatch as large on the screen as it looks from a distance. The eye sees the same angle where
//   size on the screen / distance of the eye from the screen = size of the cloth / distance of the eye from the cloth.

#include <string>

#include "session/editing/cloth_view.h"
#include "session/files/user_files.h"

namespace weftlight::session {

/// A credit card, ISO/IEC 7810 ID-1, and the radius of its corners.
inline constexpr float kCardWidth_mm = 85.60f, kCardHeight_mm = 53.98f, kCardCorner_mm = 3.18f;

/// A screen as the window system describes it.
struct Screen {
  std::string name;   // with its resolution, which the calibration is for
  float px_a_mm = 0;  // window units, by the size that it claims; often wrong. 0: unknown
};

/// Window units in a millimetre: calibrated, otherwise as the screen claims, otherwise as at 96 dpi.
float px_a_mm(const Settings& settings, const Screen& screen);
bool is_calibrated(const Settings& settings, const Screen& screen);

/// Size on the screen over size of the cloth. 1: as large as it will be.
float true_scale(const Settings& settings);
/// The camera's distance for that, of a picture of this size in window units.
float true_view_distance(const Settings& settings, const Screen& screen, float width_px, float height_px);

/// The distance after turns of the wheel, nearer for positive ones.
float stepped_distance_m(float from_m, float steps);
/// "2.00 m", "6 ft 7 in".
std::string distance_text(float m, bool imperial);

}  // namespace weftlight::session
