#pragma once
// The few controls the panels are made of. Each notes its place in the UiMap under its id.

#include <span>
#include <string>

#include "panels/panel.h"

namespace weftlight {

struct SliderSpec {
  const char* id;       // name in the --ui-map, "yarn.turns_per_m"
  const char* label;
  float min, max;
  const char* format;   // with the unit, "%.0f /m"
  const char* tip;
  bool logarithmic = false;
};

/// Label, track and figure in a row. True while it changes `value`. Ctrl+click types a number.
bool slider(const PanelContext& c, const SliderSpec& spec, float& value);
/// A row of choices of which one is taken. True when another was clicked.
bool segmented(const PanelContext& c, const char* id, std::span<const char* const> labels, int& chosen,
               float width = 0);
/// A drop-down list; when true, fill it and call end_combo.
bool begin_combo(const PanelContext& c, const char* id, const char* shown);
void end_combo();
/// Small text above a group; returns whether the group is open.
bool section(const PanelContext& c, const char* id, const char* label, bool open_at_first = true);
/// A label in the column of the sliders' labels; what follows stands beside it.
void row_label(const PanelContext& c, const char* label, const char* tip);
/// A square button with an icon, or the word where there are no icons.
bool icon_button(const PanelContext& c, const char* id, const char* icon, const char* word, const char* tip,
                 bool enabled = true);
bool text_button(const PanelContext& c, const char* id, const char* label, const char* tip);
/// Shown for the last item after the pointer has rested on it.
void tooltip(const PanelContext& c, const char* tip);
void muted_text(const PanelContext& c, const std::string& text);
std::string fixed(float value, int decimals);

}  // namespace weftlight
