#pragma once
// Shared parts of the dialogs.

#include <string>
#include <vector>

#include "views/dialogs/dialogs.h"

namespace weftlight::views {

using session::MaybeEdit;
using weaves::WeaveKind, weaves::WeaveValues;

void heading(PanelContext& c, const std::string& text);
/// The id of the text field in ImGui::InputInt with steps, under its id.
unsigned field_of_number(const char* label);
/// A labelled whole number with steps of one and ten.
void number(PanelContext& c, const char* id, const char* label, int& value, int min, int max);
/// The buttons at the lower right; the first is the primary one and outermost. Labels are marked texts, and the map has
/// them in English as dialog:LABEL. Returns the index of the pressed one or -1.
int draw_buttons(PanelContext& c, const std::vector<std::string>& labels, bool enter_presses_first);
/// The result for what draw_buttons returned.
DialogResult dialog_result(int button, int cancel_button = 1);
/// The result of the buttons of a dialog whose draft follows.
DialogResult edited(MaybeEdit edit, DialogResult buttons);

/// The weaves of weave_kinds() by family, those that have the `typed` words. True if another was chosen. Sizes in
/// pixels at 96 dpi.
bool draw_weave_list(PanelContext& c, int& chosen, std::string& typed, float width, float height);
/// A row for each parameter of the weave. True if one changed.
bool draw_weave_numbers(PanelContext& c, const WeaveKind& kind, WeaveValues& values);
DialogResult draw_weave_over(PanelContext& c, WeaveOverPrompt& p);
/// The edit that restores the draft as the dialog found it.
MaybeEdit restored(const WeaveOverPrompt& p);
DialogResult draw_sections(PanelContext& c, SectionsPrompt& p);
MaybeEdit restored(const SectionsPrompt& p);
DialogResult draw_join(PanelContext& c, JoinPrompt& p);
MaybeEdit restored(const JoinPrompt& p);
DialogResult draw_gradient(PanelContext& c, GradientPrompt& p);
MaybeEdit restored(const GradientPrompt& p);
DialogResult draw_closest_weave(PanelContext& c, ClosestWeavePrompt& p);
MaybeEdit restored(const ClosestWeavePrompt& p);
DialogResult draw_picture(PanelContext& c, PicturePrompt& p);
DialogResult draw_versions(PanelContext& c, VersionsPrompt& p);
DialogResult draw_yarns(PanelContext& c, YarnsPrompt& p);
DialogResult draw_card(PanelContext& c, CardPrompt& p);
DialogResult draw_gallery(PanelContext& c, GalleryPrompt& p);
DialogResult draw_export_prompt(PanelContext& c, ExportPrompt& p);
DialogResult draw_print_prompt(PanelContext& c, PrintPrompt& p);
DialogResult draw_weave_prompt(PanelContext& c, WeavePrompt& p);

}  // namespace weftlight::views
