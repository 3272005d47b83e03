#pragma once
// What the dialogs are made of.

#include <string>
#include <vector>

#include "views/common/names.h"
#include "views/dialogs/dialogs.h"

namespace weftlight::views {

void heading(PanelContext& c, const std::string& text);
/// A labelled whole number with steps of one and ten.
void number(PanelContext& c, const char* id, const char* label, int& value, int min, int max);
/// The buttons at the lower right, the first the primary one and outermost. Index pressed or -1.
int draw_buttons(PanelContext& c, const std::vector<std::string>& labels, bool enter_presses_first);
/// What draw_buttons gave as an answer.
DialogAnswer answered(int button, int leave_button = 1);

/// The weaves of weave_kinds() by family; true when another became the chosen one. Pixels at 96 dpi.
bool draw_weave_list(PanelContext& c, int& chosen, float width, float height);
/// A row for each number of the weave; true when one became another.
bool draw_weave_numbers(PanelContext& c, const WeaveKind& kind, WeaveValues& values);
DialogAnswer draw_weave_over(PanelContext& c, WeaveOverPrompt& p);
/// The draft as it was before.
MaybeEdit given_back(const WeaveOverPrompt& p);
DialogAnswer draw_sections(PanelContext& c, SectionsPrompt& p);
MaybeEdit given_back(const SectionsPrompt& p);
DialogAnswer draw_closest_weave(PanelContext& c, ClosestWeavePrompt& p);
MaybeEdit given_back(const ClosestWeavePrompt& p);
DialogAnswer draw_gallery(PanelContext& c, GalleryPrompt& p);
DialogAnswer draw_export_prompt(PanelContext& c, ExportPrompt& p);
DialogAnswer draw_print_prompt(PanelContext& c, PrintPrompt& p);
DialogAnswer draw_weave_prompt(PanelContext& c, WeavePrompt& p);

}  // namespace weftlight::views
