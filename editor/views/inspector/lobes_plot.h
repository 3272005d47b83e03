#pragma once
// Polar plot of the light scattered by a yarn, for one light direction.

#include <array>
#include <vector>

#include "cloth/cloth.h"
#include "views/common/panel.h"

namespace weftlight::views {

using cloth::Linear;
using design::Lobes;
using draft::Rgb;

/// Radiance relative to white paper that faces the light, for view angles from -90 to 90 degrees off the normal in
/// steps of half a degree. The light is on the positive side. Body, fuzz and through: in the plane along the fibre.
struct LobeCurves {
  static constexpr int kCount = 361;
  using Curve = std::array<float, kCount>;
  Curve along{}, across{};  // specular, in the planes along and across the fibre
  Curve body{}, fuzz{};
  Curve through{};  // transmitted; angles off the reversed normal

  static float angle_deg(int i) { return -90 + 0.5f * static_cast<float>(i); }
};
LobeCurves lobe_curves(const Lobes& lobes, Linear colour, float light_deg);

/// Brightness at the rim of the plot: the smallest of 1, 3, 10, 30 ... 1000 that contains the curves.
float rim_brightness(const LobeCurves& curves);
/// Radius for a brightness, as a fraction of the plot's: the cube root, so that both the diffuse body and a sharp
/// highlight show; clamped to 1.
float plotted_radius(float brightness, float rim);

/// Height of the plot for a width.
float lobes_plot_height(const PanelContext& c, float width);
/// Draws the plot over the available width. Dragging in it turns the light (Settings::lobe_light_deg).
void draw_lobes_plot(PanelContext& c, const Lobes& lobes, Rgb colour);

}  // namespace weftlight::views
