#pragma once
// How a yarn throws light back, as curves around a point of the thread, for one direction of the light.

#include <array>
#include <vector>

#include "cloth/cloth.h"
#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// Brightness beside white paper that faces the light, seen from -90 to 90 degrees off the normal in steps of
/// half a degree; the light is on the positive side. Body, fuzz and through: in the plane along the fibre.
struct LobeCurves {
  static constexpr int kCount = 361;
  using Curve = std::array<float, kCount>;
  Curve along{}, across{};  // mirrored, in the plane along the fibre and in that across it
  Curve body{}, fuzz{};
  Curve through{};  // seen from behind, the normal turned over

  static float angle_deg(int i) { return -90 + 0.5f * static_cast<float>(i); }
};
LobeCurves lobe_curves(const Lobes& lobes, Linear colour, float light_deg);

/// Brightness of the plot's rim: the least of 1, 3, 10, 30 ... 1000 that holds the curves.
float rim_brightness(const LobeCurves& curves);
/// Share of the plot's radius for a brightness: the cube root, so that a dull body and a sharp highlight both
/// show; held at 1 beyond the rim.
float plotted_radius(float brightness, float rim);

/// Height of what draw_lobes_plot draws over a width.
float lobes_plot_height(const PanelContext& c, float width);
/// Draws the plot over the width that there is. Dragging in it turns the light (Settings::lobe_light_deg).
void draw_lobes_plot(PanelContext& c, const Lobes& lobes, Rgb colour);

}  // namespace weftlight::views
