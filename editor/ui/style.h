#pragma once
// The look of the window: one set of colours, fonts and spacings, handed to every panel.

#include <imgui.h>

#include "ui/names.h"

namespace weftlight::ui {

struct Colors {
  ImU32 window, panel, raised;  // backgrounds, from the furthest back
  ImU32 line, line_strong;      // hairlines and every fifth
  ImU32 text, muted;            // contrast against `panel`: 7:1 and 4.5:1 or better
  ImU32 accent, accent_soft;    // what is chosen; what the pointer is over
  ImU32 ink, paper;             // a filled and an empty cell
  ImU32 warn, error;
};

struct Fonts {
  ImFont* text = nullptr;
  ImFont* small = nullptr;
  ImFont* bold = nullptr;
  ImFont* mono = nullptr;
  ImFont* mono_small = nullptr;
  ImFont* title = nullptr;  // read from a step away
  ImFont* big = nullptr;    // figures alone, read from across the room
  bool icons = false;       // Font Awesome was found
};

struct Style {
  Colors color{};
  Fonts font;
  bool dark = false;
  float scale = 1;  // of the display: 1 at 96 dpi

  /// A length of the design, on whole pixels.
  float px(float v) const { return static_cast<float>(static_cast<int>(v * scale + 0.5f)); }
};

Colors light_colors();
Colors dark_colors();
/// Sets ImGui's own colours and spacings from the style.
void apply(const Style& style);

/// Towards `to` by `share`, channel by channel.
ImU32 blend(ImU32 from, ImU32 to, float share);
ImU32 with_alpha(ImU32 color, float alpha);
/// Black or white, whichever reads better on `c`.
ImU32 reading_color(ImU32 c);

}  // namespace weftlight::ui
