#pragma once
// The controls that panels are made of. Each records its position in the UiMap under its id. Labels, tips and formats
// are passed as shown, already translated; only choices and translated() take marked texts.

#include <span>
#include <string>

#include "ui/context.h"

namespace weftlight::ui {

struct SliderSpec {
  const char* id;  // name in the --ui-map: "yarn.turns_per_m"
  const char* label;
  float min, max;      // of the track, and of the figure unless figure_min, figure_max are set
  const char* format;  // with the unit: "%.0f /m"
  const char* tip;
  bool logarithmic = false;
  float figure_min = 0, figure_max = 0;  // range that can be typed, if wider than the track
};
/// A spec of a static table with its marked label, format and tip in the user's language.
SliderSpec translated(SliderSpec spec);

/// An invisible area that takes the pointer; of any size, also none.
bool hit_area(const char* id, ImVec2 size, ImGuiButtonFlags flags = 0);
/// Label, track and figure in a row. True while it changes `value`. Click the figure to type a number.
bool slider(const Context& c, const SliderSpec& spec, float& value);
/// One slider for several things: it shows the range of their values, and gives all of them the value that is set.
struct SliderSpan {
  float low = 0, high = 0;
  bool inherited = false;  // the value is not their own; drawn paler
  float room_after = 0;    // pixels left free at the end of the row
};
/// True if `value` was set, for all of them.
bool span_slider(const Context& c, const SliderSpec& spec, const SliderSpan& span, float& value);
/// Only the figure of a slider, in a frame: drag it, or click to type.
bool number_field(const Context& c, const SliderSpec& spec, bool mixed, float width, float& value);
/// A row of choices, one of them selected. True if another was clicked. The labels are marked texts: they are
/// translated when drawn, and the map has them in English, as ID:LABEL.
bool segmented(const Context& c, const char* id, std::span<const char* const> labels, int& chosen, float width = 0);
/// Between these, rows of menus and lists are as high as a finger needs.
void begin_rows(const Context& c);
void end_rows();
/// A drop-down list. If true, fill it and call end_combo.
bool begin_combo(const Context& c, const char* id, const char* shown);
void end_combo();
/// A row of a list: a click or the arrows choose it (true), Enter is for the dialog. `id`: in the map, also on its own.
bool list_row(const Context& c, const char* id, const char* label, bool chosen, float height = 0);
/// A heading that folds the group below it. True while the group is open.
bool section(const Context& c, const char* id, const char* label, bool open_at_first = true);
/// Opens the section.
void open_section(const char* id);
/// A label in the column of the slider labels; the next item is placed beside it.
void row_label(const Context& c, const char* label, const char* tip);
/// Begins a row of these text buttons below the controls, or at the left where they are too wide for that column.
void buttons_row(const Context& c, std::span<const char* const> labels);
/// A colour in a rounded square.
void draw_swatch(const Context& c, ImVec2 min, ImVec2 max, ImU32 color, bool chosen = false);
/// Gives the keyboard to the next control if Context::focus has this id.
void take_focus(const Context& c, const char* id);
/// A square button with an icon, or with the word if there is no icon font.
bool icon_button(const Context& c, const char* id, const char* icon, const char* word, const char* tip,
                 bool enabled = true);
bool text_button(const Context& c, const char* id, const char* label, const char* tip);
/// Closes menus, lists and pickers, but no dialog.
void close_popups();
/// Shown for the last item once the pointer has rested on it (Context::tip), until it leaves.
void tooltip(const Context& c, const char* tip);
/// `text`, or as much of it as fits and an ellipsis.
std::string fitted(const std::string& text, float width);
void muted_text(const Context& c, const std::string& text);
std::string fixed(float value, int decimals);

}  // namespace weftlight::ui
