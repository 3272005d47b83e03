#pragma once
// The numbers above the warp's colour bar and beside the weft's are the heads of the threads: a press on them
// chooses ends or picks, as the headings of a table choose its columns. On the bars the Select tool does the
// same, and Shift and Ctrl with any tool.

#include "views/common/names.h"
#include "views/common/panel.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

/// True while a press on a colour bar chooses rather than paints.
bool chooses_on_bar(const PanelContext& c, GridId bar);
/// Choosing on a bar, whose ImGui item was drawn last.
void choose_on_bar(PanelContext& c, const GridPane& bar);
/// Choosing by the numbers; Escape takes every choice back.
void choose_by_labels(PanelContext& c, const DraftLayout& layout);
/// What is chosen, on numbers and bars.
void draw_chosen(ImDrawList* dl, const PanelContext& c, const DraftLayout& layout);

}  // namespace weftlight::views
