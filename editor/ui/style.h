#pragma once
// The style of the window: one set of colours, fonts and spacings for all panels.

#include <imgui.h>

#include <algorithm>

namespace weftlight::ui {

struct Colors {
  ImU32 window, panel, raised;  // backgrounds, back to front
  ImU32 line, line_strong;      // grid lines, and the heavy ones
  ImU32 text, muted;            // contrast against `panel` at least 7:1 and 4.5:1
  ImU32 accent, accent_soft;    // selected; hovered
  ImU32 ink, paper;             // a filled and an empty cell
  ImU32 warn, error;
};

struct Fonts {
  ImFont* text = nullptr;
  ImFont* small = nullptr;
  ImFont* bold = nullptr;
  ImFont* mono = nullptr;
  ImFont* mono_small = nullptr;
  ImFont* title = nullptr;  // to read from a step away
  ImFont* big = nullptr;    // digits only, to read from across the room
  bool icons = false;       // true if Font Awesome was found
};

struct Style {
  Colors color{};
  Fonts font;
  bool dark = false;
  float scale = 1;   // of the display: 1 at 96 dpi
  float finger = 0;  // least height of what a finger presses, in pixels; 0 for a mouse

  /// A length of the design (96 dpi) in whole pixels.
  float px(float v) const { return static_cast<float>(static_cast<int>(v * scale + 0.5f)); }
  /// The same for the height of something that is pressed.
  float pressed_px(float v) const { return std::max(px(v), finger); }
};

Colors light_colors();
Colors dark_colors();
/// Sets ImGui's own colours and spacings from the style.
void apply(const Style& style);

/// How much the window is darkened behind a dialog, 0..1: beside a draft that follows the dialog's choices hardly,
/// since its colours are to be judged.
inline constexpr float kDim = 0.28f, kDimBesideDraft = 0.06f;
void dim_behind_dialogs(float dim);

/// Linear interpolation by `t`, per channel.
ImU32 blend(ImU32 from, ImU32 to, float t);
ImU32 with_alpha(ImU32 color, float alpha);
/// Of a row of choices: behind all of them, and behind the chosen one, which is lighter than those in either theme.
ImU32 choices_background(const Colors& colors);
ImU32 chosen_background(const Style& style);
/// Behind a note over a picture: `muted` on it keeps a contrast of 4.5:1, whatever the picture shows.
ImU32 note_background(const Colors& colors);
/// Black or white, whichever has more contrast on `c`.
ImU32 reading_color(ImU32 c);

}  // namespace weftlight::ui
