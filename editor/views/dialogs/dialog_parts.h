#pragma once
// Shared parts of the dialogs.

#include <string>
#include <vector>

#include "ui/widgets.h"
#include "views/common/panel.h"
#include "weaves/table.h"

namespace weftlight::views {

using session::MaybeEdit;
using weaves::WeaveKind, weaves::WeaveValues;

/// kOpen while the dialog is open, kDone with `button`, kCancelled by Cancel or Escape.
enum class DialogOutcome { kOpen, kDone, kCancelled };
struct DialogResult {
  DialogOutcome outcome = DialogOutcome::kOpen;
  int button = -1;
  MaybeEdit edit{};  // of a dialog whose draft follows, also while it is open
};

void heading(PanelContext& c, const std::string& text);
/// Gives the next field the keyboard when the dialog appears, so that it can be typed into at once.
void begin_here();
/// The id of the text field in ImGui::InputInt with steps, under its id.
unsigned field_of_number(const char* label);
/// A labelled whole number with steps of one and ten.
void number(PanelContext& c, const char* id, const char* label, int& value, int min, int max,
            const char* tip = nullptr);
/// A slider whose value, and the limits of `spec`, are kept in another unit: shown = kept * scale. True if it changed.
bool scaled_slider(const PanelContext& c, ui::SliderSpec spec, float scale, float& kept);
/// The buttons at the lower right, the first outermost. Labels are marked texts, and the map has them in English as
/// dialog:LABEL. Returns the index of the pressed one or -1. `primary`: set off by its colour; -1: none. `by_enter`:
/// Enter presses it. `possible`: it can be pressed.
int draw_buttons(PanelContext& c, const std::vector<std::string>& labels, bool by_enter, bool possible = true,
                 int primary = 0);
/// The result for what draw_buttons returned.
DialogResult dialog_result(int button, int cancel_button = 1);
/// The result of the buttons of a dialog whose draft follows.
DialogResult edited(MaybeEdit edit, DialogResult buttons);

/// The weaves of weave_kinds() that have every typed word: those of that name, whose names begin so or have the words,
/// then those that have them with their family, and with their description.
std::vector<int> found_weaves(const std::string& typed);
/// The weaves of weave_kinds() by family, or those that are found; the best is chosen. True if another was chosen.
/// Sizes in pixels at 96 dpi.
bool draw_weave_list(PanelContext& c, int& chosen, std::string& typed, float width, float height);
/// A row for each parameter of the weave. True if one changed.
bool draw_weave_numbers(PanelContext& c, const WeaveKind& kind, WeaveValues& values);

}  // namespace weftlight::views
