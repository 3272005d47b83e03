#pragma once
// The few controls the panels are made of. Each notes its place in the UiMap under its id.

#include <span>
#include <string>

#include "ui/context.h"
#include "ui/names.h"

namespace weftlight::ui {

struct SliderSpec {
  const char* id;  // name in the --ui-map, "yarn.turns_per_m"
  const char* label;
  float min, max;      // of the track, and of the figure unless the next say more
  const char* format;  // with the unit, "%.0f /m"
  const char* tip;
  bool logarithmic = false;
  float figure_min = 0, figure_max = 0;  // what can be typed, where that is more than the track spans
};

/// A place that takes the pointer and draws nothing; of any size, also none.
bool hit_area(const char* id, ImVec2 size, ImGuiButtonFlags flags = 0);
/// Label, track and figure in a row. True while it changes `value`. A click on the figure types a number.
bool slider(const Context& c, const SliderSpec& spec, float& value);
/// What several things have under one slider: it shows their span, and setting it gives them one value.
struct SliderSpan {
  float low = 0, high = 0;
  bool inherited = false;  // shown as something that comes from elsewhere
  float room_after = 0;    // pixels kept free at the end of the row
};
/// True when `value` became what all shall have.
bool span_slider(const Context& c, const SliderSpec& spec, const SliderSpan& span, float& value);
/// The figure of a slider alone, in a frame: drag it, or click to type.
bool number_field(const Context& c, const SliderSpec& spec, bool mixed, float width, float& value);
/// A row of choices of which one is taken. True when another was clicked.
bool segmented(const Context& c, const char* id, std::span<const char* const> labels, int& chosen, float width = 0);
/// A drop-down list; when true, fill it and call end_combo.
bool begin_combo(const Context& c, const char* id, const char* shown);
void end_combo();
/// Small text above a group; returns whether the group is open.
bool section(const Context& c, const char* id, const char* label, bool open_at_first = true);
/// Opens the section, whatever it was.
void open_section(const char* id);
/// A label in the column of the sliders' labels; what follows stands beside it.
void row_label(const Context& c, const char* label, const char* tip);
/// A colour in a rounded square.
void draw_swatch(const Context& c, ImVec2 min, ImVec2 max, ImU32 color, bool chosen = false);
/// Gives the next control the keyboard when the workspace asks for it by this id.
void take_focus(const Context& c, const char* id);
/// A square button with an icon, or the word where there are no icons.
bool icon_button(const Context& c, const char* id, const char* icon, const char* word, const char* tip,
                 bool enabled = true);
bool text_button(const Context& c, const char* id, const char* label, const char* tip);
/// Menus, lists and pickers; not a dialog.
void close_popups();
/// Shown for the last item once the pointer has rested on it (Context::tip), and until it leaves.
void tooltip(const Context& c, const char* tip);
/// `text`, or as much of it as fits and three dots.
std::string fitted(const std::string& text, float width);
void muted_text(const Context& c, const std::string& text);
std::string fixed(float value, int decimals);

}  // namespace weftlight::ui
